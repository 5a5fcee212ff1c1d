# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_viewer.bash VIEWER MESH [PICTURE]: on the display at hand, starts the viewer, presses its keys, and compares what is drawn.
# PICTURE receives the first window, at the resolution that QT_SCALE_FACTOR sets.
set -euo pipefail

viewer=$1 mesh=$2 picture=${3:-} scale=${QT_SCALE_FACTOR:-1}
fail() { echo "test_viewer: $*" >&2; exit 1; }

# A display that has just been started may refuse the first connections. It must not reset itself after the last one (-noreset).
for _ in $(seq 50); do
  xdotool getdisplaygeometry > /dev/null 2>&1 && break
  sleep 0.2
done

"$viewer" "$mesh" 400 &
process=$!
trap 'kill $process 2> /dev/null || true' EXIT

# wait_for TITLE: until the title of the window ends so.
wait_for() {
  for _ in $(seq 600); do
    kill -0 $process 2> /dev/null || fail "the viewer has ended"
    window=$(xdotool search --onlyvisible --pid $process 2> /dev/null | tail -1) || true
    title=$(xdotool getwindowname "$window" 2> /dev/null) || true
    [[ $title == *"$1" ]] && { sleep 1; return; }
    sleep 0.2
  done
  fail "the title is '$title', not '$1'"
}

# shot NAME: what the window shows, as numbers of pixels; its four pictures are NAME-0 to NAME-3.
shot() {
  import -window "$window" "$1.png"
  local width height
  read -r width height < <(identify -format "%w %h\n" "$1.png")
  for i in 0 1 2 3; do
    convert "$1.png" -crop "$((width / 4))x$((height - 170 * scale))+$((i * width / 4))+$((80 * scale))" +repage "$1-$i.png"
  done
}

same() { [[ $(identify -format '%#' "$1.png") == $(identify -format '%#' "$2.png") ]]; }
colors() { identify -format "%k" "$1.png"; }
press() { xdotool windowfocus --sync "$window" key "$1"; }

wait_for "400 vertices, weight area, placement fitted"
shot first
[[ -z $picture ]] || cp first.png "$picture"
for i in 0 1 2 3; do
  (( $(colors first-$i) > 30 )) || fail "picture $i shows nothing: $(colors first-$i) colors"
done
same first-0 first-1 && fail "the clusters look like the input"
same first-2 first-3 && fail "the error looks like the result"

# Another number of vertices changes all but the input.
press plus
wait_for "500 vertices, weight area, placement fitted"
shot more
same first-0 more-0 || fail "the input has changed with the number of vertices"
for i in 1 2 3; do
  ! same first-$i more-$i || fail "picture $i is the same for 500 vertices"
done
press minus
wait_for "400 vertices, weight area, placement fitted"
shot back
same first back || fail "400 vertices look different after 500"

# Another placement has the same clusters.
press p
wait_for "400 vertices, weight area, placement centroid"
shot centroid
same first-0 centroid-0 || fail "the input has changed with the placement"
same first-2 centroid-2 && fail "the result is the same with centroids"
same first-3 centroid-3 && fail "the error is the same with centroids"
press w
wait_for "400 vertices, weight maximum, placement centroid"
shot maximum
same centroid-1 maximum-1 && fail "the clusters are the same with another weight"

# The pictures turn together, and back.
press Left
sleep 2
shot turned
for i in 0 1 2 3; do
  ! same maximum-$i turned-$i || fail "picture $i does not turn"
done
press Right
sleep 2
shot turned_back
same maximum turned_back || fail "the view is not the same after it was turned there and back"
echo "the viewer draws what it should"
