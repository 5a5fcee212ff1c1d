# SPDX-License-Identifier: GPL-3.0-or-later
#
# Completion of coarsen_mesh for bash. It does not need the package bash-completion.

_coarsen_mesh()
{
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  # bash breaks words at '=': the option precedes it.
  if [[ $word == "=" ]]; then
    word=
  elif [[ $before == "=" && $COMP_CWORD -ge 2 ]]; then
    before=${COMP_WORDS[COMP_CWORD-2]}
  fi

  local endings= values=
  case $before in
    -w | --weight) values="uniform area maximum exact-maximum variance" ;;
    --energy) values="weighted quadric normals" ;;
    --fill-holes) values=all ;;
    --format) values="off obj ply stl" ;;
    --patches) values="material group object solid" ;;
    --placement) values="centroid closest-vertex quadric fitted" ;;
    --clusters) endings=ply ;;
    --picture) endings=png ;;
    --report) endings=json ;;
    -n | --vertices | --faces | -k | --neighborhood-level | --maximum-distance | --maximum-distance-absolute | --levels | \
    --rounds | --convergence-tolerance | --maximum-density | --angle | --error-feedback | --view | --up | \
    --minimum-component-area | --threads | --keep | --weld) return ;;
    *)
      if [[ $word == -* ]]; then
        values="--vertices --keep-small --faces --range --neighborhood-level --maximum-distance --maximum-distance-absolute --levels --rounds --convergence-tolerance --energy --weight --maximum-density --placement --angle --error-feedback --paper --features --patches --keep-borders --keep --clusters --picture
          --view --up --report --format --repair --weld --fill-holes --minimum-component-area --subdivide --measure --distances --threads --force --quiet
          --version --help -n -k -w -h"
      else
        endings="off obj ply stl glb gltf dae"
      fi ;;
  esac

  COMPREPLY=()
  local name ending
  if [[ -n $values ]]; then
    while IFS= read -r name; do
      COMPREPLY+=("$name")
    done < <(compgen -W "$values" -- "$word")
    return
  fi
  compopt -o filenames 2> /dev/null
  while IFS= read -r name; do
    COMPREPLY+=("$name")
  done < <(compgen -d -- "$word")
  for ending in $endings; do
    while IFS= read -r name; do
      COMPREPLY+=("$name")
    done < <(compgen -f -X "!*.$ending" -- "$word")
  done
}

complete -F _coarsen_mesh coarsen_mesh
