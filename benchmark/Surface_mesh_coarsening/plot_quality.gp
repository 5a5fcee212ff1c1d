# SPDX-License-Identifier: GPL-3.0-or-later
#
# Plots quality.csv, the output of compare_peers for several numbers of vertices of each of the `models`, to quality.png: distance
# against shape, a panel for each model and a line for each method from many vertices, below, to few.

set terminal pngcairo size 2200,1840 font ",9" fontscale 2 linewidth 2 pointscale 2
set output "quality.png"
set datafile separator comma
set datafile missing NaN # lines go on past the rows of other methods
methods = "\"ours maximum\" \"ours maximum quadric\" \"ours area fitted\" \"CGAL edge collapse\" \"CGAL edge collapse by planes\" \"CGAL ACVD\" meshoptimizer \"OpenMesh decimation\""
method(i) = word(methods, i)
array colors[8] = ["#88bb88", "#449944", "#006600", "#cc4444", "#ee9966", "#8855bb", "#4477cc", "#888888"]
columns = 4
panels = words(models) + 1
rows = (panels + columns - 1) / columns
set multiplot layout rows,columns
set logscale y
set format y "%g"
set xrange [10:55]
set grid
set key off
do for [m = 1:words(models)] {
  set title word(models, m) noenhanced offset 0,-0.7
  set xlabel (m > words(models) - columns ? "mean smallest angle, degrees" : "")
  set ylabel ((m - 1) % columns == 0 ? "RMS distance, % of the diagonal" : "")
  plot for [i = 1:8] "quality.csv" skip 1 \
    using (strcol(1) eq word(models, m) && strcol(4) eq method(i) ? $18 : NaN):15 \
    with linespoints linecolor rgb colors[i] pointtype i pointsize 0.7 notitle
}
# The last panel shows the legend.
unset title
unset xlabel
unset ylabel
unset border
unset tics
unset grid
set key center center
unset logscale
set yrange [0:1]
plot for [i = 1:8] NaN with linespoints linecolor rgb colors[i] pointtype i title method(i)
unset multiplot
