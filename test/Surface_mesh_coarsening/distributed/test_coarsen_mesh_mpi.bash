#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs coarsen_mesh_mpi on several numbers of ranks and threads, within memory and beyond it, and with faults of all kinds.
#   test_coarsen_mesh_mpi.bash COARSEN_MESH_MPI WRITE_INPUTS MPIEXEC NUMPROC_FLAG

tool=$1 write_inputs=$2 mpiexec=$3 numproc_flag=$4
faults=0

fault()
{
  echo "FAULT: $*"
  faults=$((faults + 1))
}

# on RANKS ARGUMENT...
on()
{
  local ranks=$1
  shift
  "$mpiexec" "$numproc_flag" "$ranks" "$tool" "$@"
}

rm -rf ./*
mkdir scratch
ln -s /dev/full full.off
$write_inputs || exit 1
common=(-n 90 --faces-per-block 60 --quiet)

# The same bytes for all ranks, threads, memories, and distributions over files.
"$tool" polygons.ply expected.off "${common[@]}" || fault "one rank without mpirun failed"
head -2 expected.off | grep -q "^90 " || fault "the output has another number of vertices"
for run in "1 1" "2 1" "2 2" "3 2" "4 1" "7 1"; do
  set -- $run
  on "$1" polygons.ply out.off "${common[@]}" --threads "$2" || fault "$1 ranks with $2 threads failed"
  cmp expected.off out.off || fault "$1 ranks with $2 threads give another result"
done
on 3 polygons.ply out.off "${common[@]}" --memory 1K --scratch scratch || fault "scratch files failed"
cmp expected.off out.off || fault "scratch files give another result"
on 3 piece_0.ply piece_1.ply piece_2.ply out.off "${common[@]}" --clusters clusters.pvtp || fault "several pieces failed"
cmp expected.off out.off || fault "several pieces give another result"
[ "$(grep -c '<Piece Source' clusters.pvtp)" = 3 ] && [ -s clusters_2.vtp ] || fault "the clusters were not written"
rm -f clusters*
"$tool" triangles.ply expected.off "${common[@]}"
on 4 triangles.ply out.off "${common[@]}" || fault "triangles failed"
cmp expected.off out.off || fault "four ranks give another result for triangles"
on 2 triangles.ply out.off "${common[@]}" --placement quadric || fault "the placement by quadrics failed"
cmp -s expected.off out.off && fault "the fit does not move vertices"
on 2 large.ply expected.off -n 300 --faces-per-block 20000 --quiet || fault "a large mesh failed"
on 2 large.ply out.off -n 300 --faces-per-block 20000 --quiet --memory 1K --scratch scratch --report report.json ||
  fault "scratch files failed for a large mesh"
cmp expected.off out.off || fault "scratch files give another result for a large mesh"
grep -q '"bytes_of_scratch": [1-9]' report.json || fault "nothing was written to scratch files"
on 3 plate.ply out.off -n 60 --faces-per-block 4000 --quiet --report report.json || fault "a thin plate failed"
grep -q '"intersections_found": [1-9]' report.json || fault "no triangles of a thin plate intersect after the fit"
grep -q '"intersections_left": 0' report.json || fault "triangles of a thin plate still intersect"
rm -f out.off

# refuses MESSAGE RANKS ARGUMENT...: the run fails with the message, once, and leaves no file.
refuses()
{
  local message=$1
  shift
  on "$@" > output.txt 2>&1
  [ $? = 1 ] || fault "was accepted, or has another exit status than 1: $*"
  [ "$(grep -c "^coarsen_mesh_mpi: .*$message" output.txt)" = 1 ] || { fault "no or another message for: $*"; cat output.txt; }
  ls out.* clusters* .coarsen_mesh* scratch/* 2> /dev/null && fault "files are left by: $*"
}

for ranks in 1 3; do
  refuses "cut_in_faces.ply: is cut off: it ends after .* bytes, in or before face" $ranks \
    cut_in_faces.ply out.off "${common[@]}"
  refuses "cut_in_triangles.ply: is cut off" $ranks cut_in_triangles.ply out.off "${common[@]}"
  refuses "cut_in_vertices.ply: is cut off" $ranks cut_in_vertices.ply out.off "${common[@]}"
  refuses "longer_polygons.ply: has 4 bytes after its last element" $ranks longer_polygons.ply out.off "${common[@]}"
  refuses "longer_triangles.ply: has 1 bytes after its last element" $ranks longer_triangles.ply out.off "${common[@]}"
  refuses "fractions.ply: has a property vertex_number whose type is not whole" $ranks \
    fractions.ply piece_0.ply out.off "${common[@]}"
  refuses "piece_3.ply: cannot be read" $ranks piece_0.ply piece_3.ply out.off "${common[@]}"
  refuses "face .* of .* is face .* of .*, too" $ranks piece_0.ply piece_1.ply again.ply out.off "${common[@]}"
  refuses "vertex [0-9]* has two positions, in face [0-9]* of piece_1.ply and in face [0-9]* of moved.ply" $ranks \
    piece_0.ply piece_1.ply moved.ply out.off "${common[@]}"
  refuses "two faces on the same side, face [0-9]* of .*.ply and face [0-9]* of .*.ply: their orientations" $ranks \
    piece_0.ply piece_1.ply reversed.ply out.off "${common[@]}"
  refuses "vertices have no property vertex_number" $ranks piece_0.ply polygons.ply out.off "${common[@]}"
  refuses "3 " $ranks polygons.ply out.off -n 3 --clusters clusters.pvtp
  refuses "no/where" $ranks polygons.ply out.off "${common[@]}" --memory 1K --scratch no/where
  refuses "full.off: cannot be written: No space left on device" $ranks \
    polygons.ply full.off "${common[@]}" --clusters clusters.pvtp
  refuses "would replace the input" $ranks polygons.ply polygons.ply "${common[@]}"
  refuses "how many vertices" $ranks polygons.ply out.off
  refuses "takes fitted or quadric" $ranks polygons.ply out.off "${common[@]}" --placement centroid
done

# A disk that has room for the messages of MPI, but not for the faces.
(ulimit -f 20000 && "$tool" large.ply out.off -n 100 --memory 1K --scratch scratch > output.txt 2>&1) &&
  fault "a full disk was accepted"
grep -q "cannot write to a scratch file in scratch: " output.txt || { fault "no message for a full disk"; cat output.txt; }
ls out.* scratch/* 2> /dev/null && fault "files are left by a full disk"

# has_running_ranks MPIEXEC: whether a rank still runs; zombies do not.
has_running_ranks()
{
  ps -o stat= --ppid "$1" | grep -qv '^Z'
}

# killed_after SECONDS: a rank is killed so long after its start. All end, the output does not change, and no file is left.
killed_after()
{
  echo "an older output" > out.off
  "$mpiexec" "$numproc_flag" 3 "$tool" large.ply out.off -n 1000 --faces-per-block 3000 --memory 1K --scratch scratch \
    > output.txt 2>&1 &
  local parent=$! child= i
  for ((i = 0; i < 200; ++i)); do
    child=$(pgrep -P $parent | tail -1)
    [ -n "$child" ] && [ "$(readlink "/proc/$child/exe")" = "$(readlink -f "$tool")" ] && break
    sleep 0.05
  done
  sleep "$1"
  if kill -KILL "$child"; then
    for ((i = 0; i < 200; ++i)); do
      has_running_ranks $parent || break
      sleep 0.05
    done
    has_running_ranks $parent && { fault "the other ranks go on"; pkill -KILL -P $parent; }
    # All ranks have ended, but the mpiexec of Open MPI 4.1 sometimes waits forever for its own lock in PMIx_server_finalize().
    for ((i = 0; i < 40; ++i)); do
      kill -0 $parent 2> /dev/null || break
      sleep 0.05
    done
    kill -KILL $parent 2> /dev/null
    wait $parent && fault "a run without one of its ranks has succeeded"
    [ "$(cat out.off)" = "an older output" ] || fault "a rank killed after $1 s changes the output"
  else
    fault "no rank was there to be killed after $1 s"
  fi
  rm out.off
  ls out.* .coarsen_mesh* scratch/* 2> /dev/null && fault "files are left by a rank killed after $1 s"
}

for seconds in 0 0.1 0.2 0.3; do
  killed_after $seconds
done

exit $((faults > 0))
