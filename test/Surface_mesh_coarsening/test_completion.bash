#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Completes command lines of coarsen_mesh like bash.
#   test_completion.bash COARSEN_MESH COMPLETION
set -u
tool=$1
source "$2"

directory=$(mktemp -d)
trap 'rm -r "$directory"' EXIT
cd "$directory"
touch model.off "scan of a head.ply" notes.txt picture.png
mkdir folder

failures=0
# expect WHAT EXPECTED WORD...: the last word is the one to be completed.
expect()
{
  local what=$1 expected=$2
  shift 2
  COMP_WORDS=(coarsen_mesh "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _coarsen_mesh
  local got
  got=$(printf '%s\n' ${COMPREPLY[@]+"${COMPREPLY[@]}"} | sort | tr '\n' '|')
  if [[ $got != "$expected" ]]; then
    echo "$what: expected '$expected', got '$got'"
    failures=$((failures + 1))
  fi
}
# The values in the tool's message about an invalid one.
values()
{
  "$tool" in.off out.off "$1" none 2>&1 | sed -n 's/.*is one of \([a-z, -]*\), not.*/\1/p' | sed 's/, /\n/g' | sort | tr '\n' '|'
}
# A list in the order of expect().
sorted() { sort | tr '\n' '|'; }

long=$("$tool" --help | grep -oE '^  (-[a-z] \[ )?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sorted)
[[ $(tr -cd '|' <<< "$long" | wc -c) -ge 15 ]] || { echo "--help describes too few options: $long"; failures=1; }
expect "all long options" "$long" --
expect "two options" "$(printf -- '--version\n--vertices\n' | sorted)" --ver
expect "values of --weight" "$(values --weight)" --weight ""
expect "values of -w" "$(values --weight)" -w ""
expect "values of --weight=" "$(values --weight)" --weight =
expect "a value begun" "variance|" --weight = v
expect "values of --placement" "$(values --placement)" in.off out.off --placement ""
expect "a number" "|" -n ""
expect "meshes and directories" "$(printf 'folder\nmodel.off\nscan of a head.ply\n' | sorted)" ""
expect "a picture" "$(printf 'folder\npicture.png\n' | sorted)" --picture ""
expect "a mesh after options" "model.off|" -n 500 m

[[ $(complete -p coarsen_mesh) == *_coarsen_mesh* ]] || { echo "the completion is not registered"; failures=1; }
exit $((failures > 0))
