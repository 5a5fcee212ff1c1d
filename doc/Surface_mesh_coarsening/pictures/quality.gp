# SPDX-License-Identifier: GPL-3.0-or-later
#
# Plots `runs`, the rows of compare_quality for all models and sizes, to quality.png: distance against shape, a panel for each
# model and a line for each method from many vertices, below, to few. Runs that failed are not drawn.

set terminal pngcairo size 2200,1900 font ",9" fontscale 2 linewidth 2 pointscale 2
set output "quality.png"
set datafile separator comma
set datafile missing NaN # lines continue across the rows of other methods
models = "fandisk anchor_dense couplingdown mech-holes-shark elephant bull camel armadillo bunny horse lion-head mannequin-devil"
methods = "ours \"ours by quadrics\" \"ours by normals\" \"CGAL edge collapse\" \"CGAL edge collapse by planes\" \"CGAL ACVD\" \"CGAL ACVD by quadrics\" \"CGAL ACVD with gradation\" meshoptimizer \"OpenMesh decimation\""
method(i) = word(methods, i)
number = words(methods)
array colors[10] = ["#006600", "#44aa44", "#99cc77", "#cc2222", "#ee9944", "#552299", "#8855bb", "#bb99dd", "#4477cc", "#888888"]
columns = 4
rows = (words(models) + columns - 1) / columns
legend = 0.11 # part of the height
set multiplot
set size 1. / columns,(1 - legend) / rows
set logscale y
set format y "%g"
set xrange [10:55]
set grid
set key off
do for [m = 1:words(models)] {
  set origin ((m - 1) % columns) / (1. * columns), 1 - (1 - legend) * ((m - 1) / columns + 1) / rows
  set title word(models, m) noenhanced offset 0,-0.7
  set xlabel (m > words(models) - columns ? "mean smallest angle, degrees" : "")
  set ylabel ((m - 1) % columns == 0 ? "RMS distance, % of the diagonal" : "")
  plot for [i = 1:number] runs skip 1 \
    using (strcol(1) eq word(models, m) && strcol(3) eq method(i) && $4 > 0 ? $8 : NaN):6 \
    with linespoints linecolor rgb colors[i] pointtype i pointsize 0.7 notitle
}
# The legend is below the panels.
unset title
unset xlabel
unset ylabel
unset border
unset tics
unset grid
set size 1,legend
set origin 0,0
set key center center maxrows 4
unset logscale
set yrange [0:1]
plot for [i = 1:number] NaN with linespoints linecolor rgb colors[i] pointtype i title method(i)
unset multiplot
