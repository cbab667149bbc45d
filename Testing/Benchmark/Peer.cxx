// SPDX-License-Identifier: BSD-3-Clause
#include "Peer.h"

#include "Base/Execution.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <stdexcept>

namespace benchmarks
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace parameterization = CGAL::Surface_mesh_parameterization;

template <typename Parameterizer>
PeerResult run(const flattening::TriangleMesh& source)
{
  Mesh mesh;
  for (const flattening::Point3& p : source.points())
  {
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  }
  for (const flattening::Triangle& t : source.triangles())
  {
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  }
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const flattening::Stopwatch watch;
  const auto status = parameterization::parameterize(mesh, Parameterizer(), border, uv);
  PeerResult result;
  result.seconds = watch.seconds();
  if (status != parameterization::OK)
  {
    throw std::runtime_error(parameterization::get_error_message(status));
  }
  for (Mesh::Vertex_index v : mesh.vertices())
  {
    result.positions.emplace_back(uv[v].x(), uv[v].y());
  }
  return result;
}
}

PeerResult runConformalPeer(const flattening::TriangleMesh& mesh)
{
  return run<parameterization::LSCM_parameterizer_3<Mesh>>(mesh);
}

PeerResult runRigidPeer(const flattening::TriangleMesh& mesh)
{
  return run<parameterization::ARAP_parameterizer_3<Mesh>>(mesh);
}
}
