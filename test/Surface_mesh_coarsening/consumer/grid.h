// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSUMER_GRID_H
#define CONSUMER_GRID_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

Mesh grid();

#endif // CONSUMER_GRID_H
