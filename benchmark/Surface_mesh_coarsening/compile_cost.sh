#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiles an empty program with the header coarsen_mesh.h, and with the header of CGAL's edge collapse, and prints user
# seconds (minimum of three), lines after preprocessing, and bytes of the object file.
#
#   compile_cost.sh COMPILER OPTION...
set -e
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo "header,user_s,preprocessed_lines,object_bytes"
for header in CGAL/Surface_mesh_coarsening/coarsen_mesh.h CGAL/Surface_mesh_simplification/edge_collapse.h; do
  printf '#include <CGAL/Simple_cartesian.h>\n#include <CGAL/Surface_mesh.h>\n#include <%s>\nint main() {}\n' $header > "$work/program.cpp"
  least=
  for run in 1 2 3; do
    seconds=$(bash -c 'TIMEFORMAT=%U; time "$@"' run "$@" -c "$work/program.cpp" -o "$work/program.o" 2>&1 | tail -n 1)
    if [ -z "$least" ] || [ "$(printf '%s\n%s\n' "$seconds" "$least" | sort -n | head -n 1)" = "$seconds" ]; then
      least=$seconds
    fi
  done
  echo "$header,$least,$("$@" -E -P "$work/program.cpp" | wc -l),$(wc -c < "$work/program.o")"
done
