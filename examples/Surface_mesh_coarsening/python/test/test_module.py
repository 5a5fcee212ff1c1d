# SPDX-License-Identifier: GPL-3.0-or-later

import inspect
import multiprocessing
import os
import pickle
import signal
import sys
import threading
import time
import types

import numpy as np
import pytest

import surface_mesh_coarsening as smc


def torus(rows=40, columns=60):
    """A torus of quadrilaterals."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    u, v = 2 * np.pi * i / rows, 2 * np.pi * j / columns
    points = np.stack([(3 + np.cos(u)) * np.cos(v), (3 + np.cos(u)) * np.sin(v), np.sin(u)], axis=-1).reshape(-1, 3)

    def at(a, b):
        return (a % rows) * columns + b % columns

    faces = np.stack([at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)], axis=-1).reshape(-1, 4)
    return points, faces


def folded_sheet(n=20):
    """A unit square of quadrilaterals, folded along its middle."""
    side = np.arange(n + 1) / n
    x, y = np.meshgrid(side, side, indexing="ij")
    points = np.stack([x, y, np.abs(y - 0.5)], axis=-1).reshape(-1, 3)
    at = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    return points, np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], axis=-1).reshape(-1, 4)


def directed_edges(faces):
    return {tuple(e) for e in np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])}


def with_entry(array, index, value):
    copy = array.copy()
    copy[index] = value
    return copy


def test_points_of_single_precision_and_lists():
    points, faces = torus()
    single = points.astype(np.float32)
    one, other = (smc.coarsen(p, faces, 50) for p in (single, single.tolist()))
    assert np.array_equal(one.points, other.points)


def test_exact_number_and_topology():
    points, faces = torus()
    result = smc.coarsen(points, faces, 200)
    assert result.points.shape == (200, 3)
    assert result.faces.shape == (400, 3)  # Euler characteristic 0
    edges = directed_edges(result.faces)
    assert len(edges) == 1200 and all((b, a) in edges for a, b in edges)
    assert result.labels.shape == (len(faces),)
    assert set(result.labels) == set(range(200))
    assert result.report["clusters"] == 200


def test_layouts_and_types_agree():
    points, faces = torus()
    sizes = np.full(len(faces), 4)
    expected = smc.coarsen(points, faces, 100)
    padded = np.concatenate([sizes[:, None], faces], axis=1).ravel()
    split = (sizes, faces.ravel())
    for other in [split, padded, padded.astype(np.int16), faces.astype(np.uint32), faces.tolist(), np.asfortranarray(faces)]:
        result = smc.coarsen(np.asfortranarray(points), other, 100)
        assert np.array_equal(result.points, expected.points)
        assert np.array_equal(result.faces, expected.faces)
        assert np.array_equal(result.labels, expected.labels)


def test_polygons_of_several_sizes():
    """A prism with hexagons at its ends."""
    angle = np.arange(6) * np.pi / 3
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)
    points = np.concatenate([ring, ring + [0, 0, 1]])
    lists = [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11]] + [[i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6] for i in range(6)]
    padded = np.concatenate([[len(f)] + f for f in lists])
    split = (np.array([len(f) for f in lists]), np.concatenate(lists))
    one, other = (smc.coarsen(points, f, 6, subdivide=True) for f in (padded, split))
    assert one.points.shape == (6, 3) and one.faces.shape == (8, 3)
    assert np.array_equal(one.points, other.points) and np.array_equal(one.faces, other.faces)


def test_threads_give_the_same_result():
    points, faces = torus(100, 150)
    one, two, all_of_them = (smc.coarsen(points, faces, 150, threads=t) for t in (1, 2, None))
    for other in (two, all_of_them):
        assert np.array_equal(one.points, other.points) and np.array_equal(one.faces, other.faces)


@pytest.mark.parametrize("weight", ["uniform", "area", "maximum", "exact-maximum", "variance"])
@pytest.mark.parametrize("placement", ["centroid", "closest-vertex", "quadric", "fitted"])
def test_weights_and_placements(weight, placement):
    points, faces = torus(16, 24)
    result = smc.coarsen(points, faces, 60, weight=weight, placement=placement)
    assert len(result.points) == 60 and len(result.faces) == 120
    if placement == "closest-vertex":
        assert {tuple(p) for p in result.points} <= {tuple(p) for p in points}


def test_distance():
    points, faces = torus()
    result = smc.coarsen(points, faces, maximum_distance_absolute=0.2)
    assert 0 < result.report["distance_bound"] <= 0.2
    assert result.report["clusters"] == len(result.points)
    quality = smc.measure(points, faces, result.points, result.faces)
    assert 0 < quality["rms_distance"] <= quality["maximum_distance"] <= 0.2
    relative = smc.coarsen(points, faces, maximum_distance=0.2 / quality["diagonal"])
    assert np.array_equal(relative.points, result.points)
    small = torus(8, 12)
    with pytest.raises(smc.UnreachableDistance) as e:
        smc.coarsen(*small, maximum_distance=1e-30)
    assert 1e-30 < e.value.nearest < 1
    smc.coarsen(*small, maximum_distance=e.value.nearest)


def test_distance_with_a_number():
    points, faces = torus()
    free = smc.coarsen(points, faces, maximum_distance=0.02)
    assert free.report["is_within_distance"]
    n = len(free.points)
    fewer = smc.coarsen(points, faces, n // 2, maximum_distance=0.02)
    assert len(fewer.points) == n // 2 and not fewer.report["is_within_distance"]
    assert fewer.report["distance_bound"] > free.report["distance_bound"]
    more = smc.coarsen(points, faces, 2 * n, maximum_distance=0.02)
    assert len(more.points) < 1.2 * n and more.report["is_within_distance"]


def test_number_of_faces():
    points, faces = torus()
    assert len(smc.coarsen(points, faces, number_of_faces=300).faces) == 300
    sheet, quads = folded_sheet()
    assert abs(len(smc.coarsen(sheet, quads, number_of_faces=101).faces) - 101) <= 1


def test_small_components_are_kept():
    points, faces = torus()
    quad = np.array([[20.0, 0, 0], [21, 0, 0], [21, 1, 0], [20, 1, 0]])
    all_points = np.concatenate([points, quad])
    all_faces = np.concatenate([faces, [[len(points) + i for i in range(4)]]])
    with pytest.raises(smc.UnreachableNumberOfVertices):
        smc.coarsen(all_points, all_faces, vertex_ratio=0.001)
    result = smc.coarsen(all_points, all_faces, vertex_ratio=0.01, keep_small=True)
    assert len(result.points) == 28
    assert {tuple(p) for p in quad} <= {tuple(p) for p in result.points}


def test_small_components_are_removed():
    points, faces = torus()
    quad = np.array([[20.0, 0, 0], [21, 0, 0], [21, 1, 0], [20, 1, 0]])
    mesh = np.concatenate([quad, points]), np.concatenate([[[0, 1, 2, 3]], faces + 4])
    density = np.linspace(1, 9, len(faces))
    expected = smc.coarsen(points, faces, 100, density=density)
    result = smc.coarsen(*mesh, 100, density=np.append(1, density), minimum_component_area=1.1)
    assert result.report["dropped_components"] == 1 and expected.report["dropped_components"] == 0
    assert np.array_equal(result.points, expected.points)
    assert result.labels[0] == 100 and np.array_equal(result.labels[1:], expected.labels)
    assert not result.boundary_counts[:4].any() and np.array_equal(result.boundary_counts[4:], expected.boundary_counts)
    carried = smc.transfer(*mesh, result, face={"height": np.append(1e9, np.ones(len(faces)))}).face["height"]
    assert np.allclose(carried, 1)
    assert smc.vertex_number_range(*mesh, minimum_component_area=1.1) == smc.vertex_number_range(points, faces)
    assert smc.coarsen(*mesh, 100, minimum_component_area=0.9).report["dropped_components"] == 0
    with pytest.raises(ValueError, match="no component of the input has an area of 1e"):
        smc.coarsen(*mesh, 100, minimum_component_area=1e9)
    with pytest.raises(ValueError, match="minimum component area is -1"):
        smc.coarsen(*mesh, 100, minimum_component_area=-1)


def test_measure_of_a_mesh_itself():
    points, faces = torus()
    quality = smc.measure(points, faces, points, np.concatenate([faces[:, [0, 1, 2]], faces[:, [2, 3, 0]]]), samples=1000)
    assert quality["maximum_distance"] < 1e-12
    assert quality["diagonal"] == pytest.approx(np.sqrt(8**2 + 8**2 + 2**2))


def test_densities_steer_vertices():
    points, faces = torus()
    left = points[faces].mean(axis=1)[:, 0] < 0
    result = smc.coarsen(points, faces, 200, density=np.where(left, 100.0, 1.0))
    assert np.count_nonzero(result.points[:, 0] < 0) > 120


def test_levels_nest():
    points, faces = torus()
    numbers = [300, 120, 50]
    levels = smc.coarsen_levels(points, faces, numbers)
    assert [len(level.points) for level in levels] == numbers
    assert [len(level.faces) for level in levels] == [2 * n for n in numbers]
    assert np.array_equal(levels[0].points, smc.coarsen(points, faces, 300).points)
    for fine, coarse in zip(levels, levels[1:]):
        pairs = {(a, b) for a, b in zip(fine.labels, coarse.labels)}
        assert len(pairs) == len(fine.points)  # each cluster lies in one of the next level
    with pytest.raises(smc.UnreachableNumberOfVertices):
        smc.coarsen_levels(points, faces, [300, 3])
    with pytest.raises(ValueError, match="fall"):
        smc.coarsen_levels(points, faces, [50, 120])


def test_features_patches_and_progress():
    points, faces = folded_sheet()
    calls = []
    result = smc.coarsen(points, faces, 39, features=30, convergence_tolerance=1e-4, progress=lambda *call: calls.append(call))
    assert result.report["feature_lines"] == 1
    stages = [stage for stage, _, _ in calls]
    assert stages[0] == "preparation" and stages.index("seeding") < stages.index("growth") < stages.index("minimization")
    assert ("minimization", 1, None) in calls
    assert [call for call in calls if call[0] == "placement"] == [("placement", 0, None)] + [("placement", i, 5) for i in range(1, 6)]
    assert stages.index("placement") < stages.index("error feedback") < stages.index("repair of the result")
    flat = points * [1, 1, 0]
    assert smc.coarsen(flat, faces, 60, features=30).report["feature_lines"] == 0
    patches = (points[faces].mean(axis=1)[:, 0] < 0.5).astype(int)
    result = smc.coarsen(flat, faces, 60, patches=patches)
    assert result.report["feature_lines"] == 1
    assert np.array_equal(result.patches, (result.points[result.faces].mean(axis=1)[:, 0] < 0.5).astype(int))
    within = smc.coarsen(flat, faces, maximum_distance=0.01, patches=patches)
    assert set(within.patches) == {0, 1} and len(within.patches) == len(within.faces)
    assert smc.coarsen(flat, faces, 60).patches is None


def test_values_are_carried_over():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 60)
    centers = points[faces].mean(axis=1)
    uv = points[:, :2][faces]  # of corners
    carried = smc.transfer(
        points,
        faces,
        result,
        vertex={"xyz": points, "height": points[:, 2].astype(np.float32), "rounded": np.rint(100 * points[:, 0]).astype(np.int16)},
        face={"half": np.where(centers[:, 0] < 0.5, "left", "right"), "one": np.ones(len(faces)), "label": centers[:, 0] < 0.5},
        corner={"uv": uv, "flat_uv": uv.reshape(-1, 2), "id": np.repeat(np.arange(len(faces)) // 200, 4).reshape(-1, 4)},
        policy={"one": "conservative", "rounded": "interpolated"},
    )
    assert np.abs(carried.vertex["xyz"] - result.points).max() < 0.05  # at the nearest point of the mesh
    assert carried.vertex["height"].dtype == np.float32 and carried.vertex["height"].shape == (60,)
    assert carried.vertex["rounded"].dtype == np.int16
    assert np.abs(carried.vertex["rounded"] - 100 * carried.vertex["xyz"][:, 0]).max() <= 1
    a, b, c = (result.points[result.faces[:, i]] for i in range(3))
    coarse_x = (a + b + c)[:, 0] / 3
    clear = np.abs(coarse_x - 0.5) > 0.15
    assert np.array_equal(carried.face["half"][clear], np.where(coarse_x < 0.5, "left", "right")[clear])
    assert carried.face["label"].dtype == bool
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    assert (carried.face["one"] * area).sum() == pytest.approx(np.sqrt(2), rel=1e-9)  # the area of the sheet
    assert carried.corner["uv"].shape == (len(result.faces), 3, 2)
    assert np.array_equal(carried.corner["uv"], carried.corner["flat_uv"])
    assert np.abs(carried.corner["uv"] - carried.vertex["xyz"][result.faces][:, :, :2]).max() < 0.05
    assert carried.corner["id"].shape == (len(result.faces), 3) and set(carried.corner["id"].ravel()) == {0, 1}


def test_errors_of_transfer():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 60)
    with pytest.raises(ValueError, match="'x' have shape"):
        smc.transfer(points, faces, result, vertex={"x": points[:-1]})
    with pytest.raises(ValueError, match="no policy 'mean'"):
        smc.transfer(points, faces, result, vertex={"x": points}, policy={"x": "mean"})
    with pytest.raises(ValueError, match="policy for 'y'"):
        smc.transfer(points, faces, result, vertex={"x": points}, policy={"y": "majority"})
    with pytest.raises(TypeError, match="has no means"):
        smc.transfer(points, faces, result, face={"x": np.full(len(faces), "a")}, policy={"x": "interpolated"})
    with pytest.raises(ValueError, match="faces"):
        smc.transfer(*torus(), result, vertex={})


def test_errors():
    points, faces = torus()
    with pytest.raises(smc.UnreachableNumberOfVertices, match="nearest number that works") as e:
        smc.coarsen(points, faces, 3)
    assert len(smc.coarsen(points, faces, e.value.nearest).points) == e.value.nearest
    with pytest.raises(ValueError, match="face 2 has vertex 99999 of 2400"):
        smc.coarsen(points, with_entry(faces, (2, 1), 99999), 100)
    with pytest.raises(ValueError, match="face 2 has vertex -1 of 2400"):
        smc.coarsen(points, with_entry(faces, (2, 1), -1), 100)
    with pytest.raises(ValueError, match="2-manifold"):
        smc.coarsen(points, np.concatenate([faces, faces[:1]]), 100)
    with pytest.raises(ValueError, match=r"points have \(nan, .*\) in row 0, which is not finite"):
        smc.coarsen(with_entry(points, (0, 0), np.nan), faces, 100)
    with pytest.raises(ValueError, match="no faces"):
        smc.coarsen(points, np.zeros((0, 3), dtype=int), 100)
    with pytest.raises(ValueError, match="no weight 'heavy'"):
        smc.coarsen(points, faces, 100, weight="heavy")
    with pytest.raises(ValueError, match="no placement 'here'"):
        smc.coarsen(points, faces, 100, placement="here")
    with pytest.raises(ValueError, match=r"points have shape \(2400, 2\)"):
        smc.coarsen(points[:, :2], faces, 100)
    with pytest.raises(TypeError, match="integers"):
        smc.coarsen(points, faces.astype(float), 100)
    with pytest.raises(TypeError, match="either"):
        smc.coarsen(points, faces)
    with pytest.raises(TypeError, match="either"):
        smc.coarsen(points, faces, 100, vertex_ratio=0.1)
    for number in (0, -5, 2.5):
        with pytest.raises(ValueError, match="number of vertices"):
            smc.coarsen(points, faces, number)
    with pytest.raises(ValueError, match="threads"):
        smc.coarsen(points, faces, 100, threads=0)
    with pytest.raises(ValueError, match="entry 0"):
        smc.coarsen(points, np.array([7, 1, 2]), 100)
    with pytest.raises(ValueError, match="densities have shape"):
        smc.coarsen(points, faces, 100, density=[1.0])


def test_exception_of_the_callback_ends_the_call():
    def fail(stage, done, total):
        raise RuntimeError("stop at " + stage)

    with pytest.raises(RuntimeError, match="stop at preparation"):
        smc.coarsen(*torus(), 100, progress=fail)


def test_interrupt_is_heeded_and_the_lock_is_released():
    points, faces = torus(700, 900)
    sent = []

    def interrupt():  # runs only if the interpreter's lock is released
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.5, interrupt)
    # Processes in the background may ignore the signal.
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            while not sent or time.monotonic() - sent[0] < 10:
                smc.coarsen(points, faces, 20000)
        assert time.monotonic() - sent[0] < 2
        timer.join()
    finally:
        signal.signal(signal.SIGINT, handler)


def test_input_is_not_modified():
    points, faces = torus()
    copies = points.copy(), faces.copy()
    points.flags.writeable = faces.flags.writeable = False
    smc.coarsen(points, faces, 100)
    assert np.array_equal(points, copies[0]) and np.array_equal(faces, copies[1])


def test_every_argument_is_described():
    for function in (smc.coarsen, smc.transfer):
        for name, parameter in inspect.signature(function).parameters.items():
            assert name in function.__doc__
            assert parameter.annotation is not inspect.Parameter.empty
    for name in smc.coarsening.Settings.__annotations__:
        assert name + ": " in smc.coarsen.__doc__


def test_unknown_arguments_are_refused():
    for function in (smc.coarsen, smc.coarsen_levels):
        with pytest.raises(TypeError, match=function.__name__ + r"\(\) .*'wieght'"):
            function(*torus(), [50] if function is smc.coarsen_levels else 50, wieght="area")


def wrapped_sizes(seed):
    """Returns random sizes that add up to 12 modulo 2**64."""
    random = np.random.default_rng(seed)
    sizes = random.integers(13, 2**64, size=1 + seed, dtype=np.uint64)
    rest = (12 - sum(int(size) for size in sizes)) % 2**64
    return np.append(sizes, np.array([rest], dtype=np.uint64))


@pytest.mark.parametrize(
    "sizes",
    [
        np.array([3, 3, 2**64 - 1, 7], dtype=np.uint64),  # 12 modulo 2**64
        np.array([2**62] * 4, dtype=np.int64),
        np.array([2**63 + 6, 2**63 + 6], dtype=np.uint64),
        np.array([-1, 13]),
        np.array([13]),
        np.array([2**32 + 12]),
        [3, 3, 3, 2],
        *(wrapped_sizes(seed) for seed in range(8)),
    ],
)
def test_sizes_that_do_not_fit_are_refused(sizes):
    tetrahedron = np.array([0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0])
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    for call in (
        lambda: smc.coarsen(points, (sizes, tetrahedron), 4),
        lambda: smc.measure(points, tetrahedron.reshape(-1, 3), points, (sizes, tetrahedron)),
    ):
        with pytest.raises(ValueError, match="corners, but there are 12 indices|add up to 11"):
            call()


def test_labels_that_do_not_fit_are_refused():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 60)
    for label in (-1, 61, 2**40):
        wrong = smc.Coarsening(result.points, result.faces, with_entry(result.labels, 5, label), {})
        with pytest.raises(ValueError, match=f"face 5 has label {label}"):
            smc.transfer(points, faces, wrong, face={"one": np.ones(len(faces))})


def test_types_are_refused_by_name():
    points, faces = torus()
    with pytest.raises(TypeError, match="points are of type <U"):
        smc.coarsen(points.astype(str), faces, 100)
    with pytest.raises(TypeError, match="points are of type complex"):
        smc.coarsen(points + 0j, faces, 100)
    with pytest.raises(TypeError, match="densities are of type <U"):
        smc.coarsen(points, faces, 100, density=np.full(len(faces), "1"))
    with pytest.raises(ValueError, match="faces have rows of several lengths"):
        smc.coarsen(points, faces.tolist()[:-1] + [[0, 1, 2]], 100)
    with pytest.raises(ValueError, match="patches have the value 18446744073709551615 at entry 0"):
        smc.coarsen(points, faces, 100, patches=np.full(len(faces), 2**64 - 1, dtype=np.uint64))


def test_objects_are_transferred():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 60)
    left = points[faces].mean(axis=1)[:, 0] < 0.5
    values = np.empty(len(faces), dtype=object)  # which have no order
    values[left], values[~left] = None, "right"
    names = smc.transfer(points, faces, result, face={"name": np.where(left, "left", "right"), "object": values})
    assert names.face["object"].dtype == object
    assert [v is None for v in names.face["object"]] == [v == "left" for v in names.face["name"]]
    values[0] = []
    with pytest.raises(TypeError, match="'object' cannot be compared"):
        smc.transfer(points, faces, result, face={"object": values})


def coarsened_in_a_pool(arguments):
    return smc.coarsen(*torus(), **arguments)


def test_results_and_exceptions_pass_between_processes():
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        result = pool.apply_async(coarsened_in_a_pool, ({"n": 100},)).get(60)
        assert np.array_equal(result.points, smc.coarsen(*torus(), 100).points)
        with pytest.raises(smc.UnreachableNumberOfVertices) as e:
            pool.apply_async(coarsened_in_a_pool, ({"n": 3},)).get(60)
        assert e.value.nearest == 7
    for error in (smc.UnreachableNumberOfVertices("no", 7), smc.UnreachableDistance("no", 0.13471)):
        copy = pickle.loads(pickle.dumps(error))
        assert type(copy) is type(error) and copy.nearest == error.nearest and str(copy) == str(error)
    assert str(smc.UnreachableDistance("no", 0.13471)) == "no (nearest distance found: 0.1348)"  # not less


def test_results_are_pickled():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 60)
    carried = smc.transfer(points, faces, result, vertex={"xyz": points})
    assert np.array_equal(pickle.loads(pickle.dumps(result)).labels, result.labels)
    assert np.array_equal(pickle.loads(pickle.dumps(carried)).vertex["xyz"], carried.vertex["xyz"])


def test_other_targets():
    points, faces = torus()
    ratio = smc.coarsen(points, faces, vertex_ratio=0.09)
    assert len(ratio.points) == 216
    assert np.array_equal(smc.coarsen(points, faces, target_reduction=0.91).points, ratio.points)
    level = smc.coarsen(points, faces, level=4)
    assert level.report["level"] == 4 and len(level.points) >= level.report["seeds"] > 0
    start = smc.coarsen(points, faces, start_clusters=ratio.labels, iterations=0, error_feedback=0)
    assert len(start.points) == 216
    merged = smc.coarsen(points, faces, 60, level=3)
    assert len(merged.points) == 60 and merged.report["level"] == 3
    for wrong in ({"n": 100, "vertex_ratio": 0.5}, {"level": 3, "maximum_distance": 0.1}, {}):
        with pytest.raises(TypeError, match="either"):
            smc.coarsen(points, faces, **wrong)
    for name, value in (("target_reduction", 1.0), ("vertex_ratio", np.nan), ("maximum_distance", np.nan), ("level", -1)):
        with pytest.raises(ValueError, match=name):
            smc.coarsen(points, faces, **{name: value})


def test_numbers_are_refused_by_name():
    points, faces = torus()
    for name in ("n", "iterations", "threads", "error_feedback"):
        for value in (2**64, 2.5, -1, float("nan"), float("inf")):
            with pytest.raises(ValueError, match=name):
                smc.coarsen(points, faces, **{"n": 100, name: value})
        with pytest.raises(TypeError, match=name):
            smc.coarsen(points, faces, **{"n": 100, name: "8"})
    for name in ("maximum_density", "minimum_component_area", "convergence_tolerance", "features"):
        with pytest.raises(ValueError, match=name + " is NaN"):
            smc.coarsen(points, faces, 100, **{name: float("nan")})
        with pytest.raises(TypeError, match=name + " is '1', not a number"):
            smc.coarsen(points, faces, 100, **{name: "1"})
    for name in ("subdivide", "repair_output", "paper", "keep_borders"):
        with pytest.raises(TypeError, match=name):
            smc.coarsen(points, faces, 100, **{name: "no"})
    with pytest.raises(ValueError, match="samples is 18446744073709551616"):
        smc.measure(points, faces, points, faces, samples=2**64)
    assert len(smc.coarsen(points, faces, np.float64(100), threads=np.int8(2)).points) == 100


def test_energies():
    points, faces = torus()
    results = [smc.coarsen(points, faces, 100, energy=e).points for e in ("weighted", "quadric", "normals")]
    assert [len(r) for r in results] == [100] * 3 and not np.array_equal(results[0], results[1])
    with pytest.raises(ValueError, match="no energy 'heavy'"):
        smc.coarsen(points, faces, 100, energy="heavy")
    with pytest.raises(ValueError, match="weight is 'uniform', but the energy 'quadric'"):
        smc.coarsen(points, faces, 100, energy="quadric", weight="uniform")


def test_as_in_the_paper():
    points, faces = folded_sheet()
    triangles = np.concatenate([faces[:, [0, 1, 2]], faces[:, [2, 3, 0]]])
    result = smc.coarsen(points, triangles, 40, paper=True)
    chosen = smc.coarsen(
        points,
        triangles,
        40,
        paper=True,
        placement="centroid",
        maximum_density=50,
        error_feedback=0,
        convergence_tolerance=0,
        repair_output=False,
    )
    assert np.array_equal(result.points, chosen.points)
    assert result.report["refused_by_boundary_counts"] > 0 and result.report["exchanged_vertices"] == 0
    assert smc.coarsen(points, triangles, 40).report["refused_by_boundary_counts"] == 0
    assert result.points[:, 0].min() > 0  # centroids, also on the border


def test_boundary_counts_and_densities():
    points, faces = folded_sheet()
    result = smc.coarsen(points, faces, 39)
    counts, edge = np.zeros(len(points), dtype=int), {}
    for face, corners in enumerate(faces):
        for a, b in zip(corners, np.roll(corners, -1)):
            edge.setdefault((min(a, b), max(a, b)), []).append(result.labels[face])
    for (a, b), at in edge.items():
        if len(at) == 1 or at[0] != at[1]:
            counts[[a, b]] += 1
    assert np.array_equal(result.boundary_counts, counts)
    density = smc.face_densities(points, faces)
    assert density.min() >= 1 and density.max() > 10  # near corners of the border
    assert smc.face_densities(*torus()).max() == pytest.approx(10)
    given = smc.coarsen(points, faces, 39, density=density, error_feedback=12)
    minimized = smc.coarsen(points, faces, 39, iterations=999)  # the default merges by quadrics, which have no densities
    assert np.array_equal(given.labels, minimized.labels)
    assert smc.face_densities(points, faces, maximum_density=50, paper=True).max() == pytest.approx(50)


def test_kept_elements():
    points, faces = folded_sheet()
    flat = points * [1, 1, 0]
    line = [i for i, p in enumerate(flat) if p[0] == 0.25]
    edges = np.array(list(zip(line, line[1:])))
    result = smc.coarsen(flat, faces, 60, keep_edges=edges)
    assert result.report["feature_lines"] > 0
    assert np.count_nonzero(np.abs(result.points[:, 0] - 0.25) < 1e-12) >= 2
    mask = np.zeros(len(flat), dtype=bool)
    mask[[100, 200]] = True
    one, other = (smc.coarsen(flat, faces, 60, keep_vertices=k) for k in ([100, 200], mask))
    assert np.array_equal(one.points, other.points)
    assert {tuple(flat[100]), tuple(flat[200])} <= {tuple(p) for p in one.points}
    border = {tuple(p) for p in flat if {p[0], p[1]} & {0.0, 1.0}}
    assert border <= {tuple(p) for p in smc.coarsen(flat, faces, 150, keep_borders=True).points}
    with pytest.raises(ValueError, match="keep_edges have the vertices 0 and 400 in row 1"):
        smc.coarsen(flat, faces, 60, keep_edges=[[0, 1], [0, 400]])
    with pytest.raises(ValueError, match="keep_vertices have vertex 441 of 441 at entry 1"):
        smc.coarsen(flat, faces, 60, keep_vertices=[0, 441])
    within = smc.coarsen(flat, faces, maximum_distance=0.01, keep_vertices=[100, 200])
    assert {tuple(flat[100]), tuple(flat[200])} <= {tuple(p) for p in within.points}


def test_range_of_numbers():
    points, faces = torus(12, 18)
    least, most = smc.vertex_number_range(points, faces)
    assert len(smc.coarsen(points, faces, least).points) == least and len(smc.coarsen(points, faces, most).points) == most
    with pytest.raises(smc.UnreachableNumberOfVertices):
        smc.coarsen(points, faces, least - 1)
    flat = folded_sheet()
    assert smc.vertex_number_range(*flat, keep_borders=True).least >= 80


def test_sources_of_vertices():
    points, faces = torus()
    result = smc.coarsen(points, faces, 100)
    sources = smc.vertex_sources(points, faces, result)
    assert sources.faces.shape == (100,) and sources.coordinates.shape == (100, 4)
    at = (points[faces[sources.faces]] * sources.coordinates[:, :, None]).sum(axis=1)
    nearest = smc.transfer(points, faces, result, vertex={"xyz": points}).vertex["xyz"]
    assert np.abs(at - nearest).max() < 1e-9


def test_repair():
    points, faces = folded_sheet()
    soup = points[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 4)[::-1]  # every face has its own points
    with pytest.raises(smc.UnreachableNumberOfVertices):
        smc.coarsen(*soup, 60)
    repaired = smc.repair(*soup)
    assert repaired.points.shape == points.shape and repaired.faces.shape == faces.shape
    assert repaired.report["merged coincident points"] == faces.size - len(points)
    assert len(smc.coarsen(repaired, 60).points) == 60
    torn = soup[0] + 1e-6 * (np.arange(len(soup[0])) % 2)[:, None], soup[1]  # corners nearly coincide
    assert len(smc.repair(*torn).points) > len(points)
    welded = smc.repair(*torn, weld=1e-5)
    assert welded.points.shape == points.shape and len(smc.coarsen(welded, 60).points) == 60
    torus_with_hole = torus()[0], torus()[1][1:]
    filled = smc.repair(*torus_with_hole, fill_holes=np.inf)
    assert filled.report["filled holes"] == 1 and filled.report["holes left"] == 0
    sizes, indices = filled.faces
    assert list(np.bincount(sizes)) == [0, 0, 0, 2, 2399] and indices.size == sizes.sum()
    assert smc.repair(*torus_with_hole, fill_holes=0.01).report["holes left"] == 1
    broken = with_entry(points, (0, 0), np.nan)
    assert len(smc.repair(broken, faces).points) == len(points) - 1
    with pytest.raises(ValueError, match="fill_holes is NaN"):
        smc.repair(points, faces, fill_holes=float("nan"))
    with pytest.raises(ValueError, match="weld is -1"):
        smc.repair(points, faces, weld=-1)


class LikeTrimesh:
    def __init__(self, vertices, faces, process=True):
        self.vertices, self.faces, self.process = vertices, faces, process


class LikePyVista:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces


def test_meshes_of_other_modules(monkeypatch):
    points, faces = torus()
    expected = smc.coarsen(points, faces, 100)
    padded = np.concatenate([np.full((len(faces), 1), 4), faces], axis=1).ravel()
    for mesh in (LikeTrimesh(points, faces), LikePyVista(points, padded)):
        for result in (smc.coarsen(mesh, 100), smc.coarsen(mesh, n=100), smc.coarsen_levels(mesh, [100])[0]):
            assert np.array_equal(result.points, expected.points)
        assert smc.measure(mesh, result, samples=1000)["maximum_distance"] > 0
        xyz = [smc.transfer(*m, result, vertex={"xyz": points}).vertex["xyz"] for m in ((mesh,), (points, faces))]
        assert np.array_equal(*xyz)
        assert smc.vertex_number_range(mesh).most == len(points)
    monkeypatch.setitem(sys.modules, "trimesh", types.SimpleNamespace(Trimesh=LikeTrimesh))
    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(PolyData=LikePyVista))
    back = expected.to_trimesh()
    assert back.process is False and np.array_equal(back.faces, expected.faces) and np.array_equal(back.vertices, expected.points)
    assert np.array_equal(smc.coarsen(expected.to_pyvista(), 50).points, smc.coarsen(expected, 50).points)
    with pytest.raises(TypeError, match=r"measure\(\) takes two meshes"):
        smc.measure(LikeTrimesh(points, faces))


def test_signature_has_names_and_defaults():
    for function in (smc.coarsen, smc.coarsen_levels):
        parameters = inspect.signature(function).parameters
        assert parameters["weight"].default == "area" and parameters["subdivide"].default is False
        assert all(p.kind is not inspect.Parameter.VAR_KEYWORD for p in parameters.values())
    assert set(smc.coarsening.Settings.__annotations__) == set(smc.coarsening._DEFAULTS)


def test_colors_are_interpolated():
    points, faces = torus()
    result = smc.coarsen(points, faces, 100)
    red = np.rint((points[:, 0] + 4) / 8 * 255).astype(np.uint8)
    colors = np.stack([red, 255 - red, red], axis=1)
    carried = smc.transfer(points, faces, result, vertex={"any": colors, "red": red.astype(int), "label": red})
    assert carried.vertex["any"].dtype == np.uint8
    expected = smc.transfer(points, faces, result, vertex={"x": red.astype(float)}).vertex["x"]
    for values in (carried.vertex["any"][:, 0], carried.vertex["red"]):
        assert np.abs(values - expected).max() <= 0.5
    told = smc.transfer(points, faces, result, vertex={"any": colors}, policy={"any": "majority"}).vertex["any"]
    assert {tuple(c) for c in told} <= {tuple(c) for c in colors}


@pytest.mark.parametrize("call", ["measure", "levels"])
def test_calls_heed_an_interrupt_at_once(call):
    points, faces = torus(700, 900)
    coarse = torus(300, 400)
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer = threading.Timer(2.5, interrupt)
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            while not sent or time.monotonic() - sent[0] < 10:
                if call == "measure":
                    smc.measure(points, faces, *coarse, samples=10**7)
                else:
                    smc.coarsen_levels(points, faces, [20000, 10000, 5000])
        assert time.monotonic() - sent[0] < 1
        timer.join()
    finally:
        signal.signal(signal.SIGINT, handler)
