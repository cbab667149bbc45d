// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LargeArray.h"
#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace flattening
{
using Complex = std::complex<double>;

/// A triangle in its own plane, ready to differentiate maps of it.
///
/// A linear map of the triangle to the plane is f(z) = alpha z + beta conj(z) + const with complex
/// alpha and beta; its singular values are |alpha| + |beta| and |alpha| - |beta| (negative where
/// the map turns the triangle over), the rotation nearest to it is alpha / |alpha|, and it is
/// conformal where beta = 0. With u_k the images of the corners, alpha = sum u_k conj(gradient_k)
/// and beta = sum u_k gradient_k.
struct TriangleFrame
{
  /// Half the gradient of each corner's hat function, as x + i y. They sum to zero.
  std::array<Complex, 3> gradient{};
  double area = 0.0;

  TriangleFrame() = default;
  /// \param slimmest a triangle whose height is below this fraction of its longest edge is taken to
  /// be as high as that. A triangle without any extent gets zero gradients.
  TriangleFrame(const Point3& a, const Point3& b, const Point3& c, double slimmest = 0.0)
  {
    const std::array<const Point3*, 3> corner{ &a, &b, &c };
    // The longest edge as base keeps the height accurate.
    int base = 0;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double length = (*corner[(k + 1) % 3] - *corner[k]).squaredNorm();
      if (length > longest)
      {
        longest = length;
        base = k;
      }
    }
    longest = std::sqrt(longest);
    const Point3 along = *corner[(base + 1) % 3] - *corner[base];
    const Point3 toApex = *corner[(base + 2) % 3] - *corner[base];
    if (!(longest > 0.0))
    {
      return;
    }
    const double x = along.dot(toApex) / longest;
    const double y = std::max(along.cross(toApex).norm() / longest, slimmest * longest);
    this->area = 0.5 * longest * y;
    if (!(y > 0.0))
    {
      return;
    }
    const std::array<Complex, 3> p{ Complex(0.0, 0.0), Complex(longest, 0.0), Complex(x, y) };
    for (int k = 0; k < 3; ++k)
    {
      const Complex opposite = (p[(k + 2) % 3] - p[(k + 1) % 3]) / (2.0 * longest * y);
      this->gradient[(base + k) % 3] = Complex(-opposite.imag(), opposite.real());
    }
  }

  /// A triangle of points.
  TriangleFrame(const Points3& points, const Triangle& t, double slimmest = 0.0)
    : TriangleFrame(points[t[0]], points[t[1]], points[t[2]], slimmest)
  {
  }

  /// Parts of the map that takes the corners to u.
  Complex alpha(const std::array<Complex, 3>& u) const
  {
    return (u[1] - u[0]) * std::conj(this->gradient[1]) +
      (u[2] - u[0]) * std::conj(this->gradient[2]);
  }
  Complex beta(const std::array<Complex, 3>& u) const
  {
    return (u[1] - u[0]) * this->gradient[1] + (u[2] - u[0]) * this->gradient[2];
  }
};
using TriangleFrames = LargeArray<TriangleFrame>; ///< by triangle
}
