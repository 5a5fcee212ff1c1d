// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSUMER_SPHERE_H
#define CONSUMER_SPHERE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

Mesh sphere();

#endif // CONSUMER_SPHERE_H
