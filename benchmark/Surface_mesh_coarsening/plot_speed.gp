# SPDX-License-Identifier: GPL-3.0-or-later
#
# Plots speed.csv, the output of compare_speed, to speed.png: median, minimum and maximum of each ratio.

set terminal pngcairo size 1100,700 font ",11"
set output "speed.png"
set datafile separator comma
set logscale x
set xlabel "ratio"
set grid x
set yrange [] reverse
set offsets 0, 0, 1, 1
unset key
set bars small
is_ratio(what) = strstrt(what, "bytes") == 0
plot "speed.csv" skip 1 using (is_ratio(strcol(1)) ? $8 : NaN):0:6:10:ytic(strcol(1) . ", " . strcol(2)) \
  with xerrorbars pointtype 7 linewidth 1.5
