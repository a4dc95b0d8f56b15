// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/eigen.hpp"

#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Eigen::Index;

std::string entry_name(const char* name, Index row, Index column, bool is_vector) {
  std::string text = std::string(name) + "(" + std::to_string(row);
  if (!is_vector) text += "," + std::to_string(column);
  return text + ")";
}

template <class Matrix>
MatrixX exact(const Matrix& values, const char* name) {
  MatrixX result(values.rows(), values.cols());
  for (Index j = 0; j < values.cols(); ++j) {
    for (Index i = 0; i < values.rows(); ++i) {
      try {
        result(i, j) = rational_from_double(values(i, j));
      } catch (const NumberError& error) {
        throw InputError("", entry_name(name, i, j, Matrix::IsVectorAtCompileTime != 0),
                         std::to_string(values(i, j)) + " is " + error.what(),
                         "give a finite number");
      }
    }
  }
  return result;
}

void check_shape(const char* name, Index rows, Index columns, Index want_rows,
                 Index want_columns) {
  if (rows == want_rows && columns == want_columns) return;
  const auto shape = [](Index r, Index c) {
    return std::to_string(r) + " x " + std::to_string(c);
  };
  throw InputError("", name, "the shape is " + shape(rows, columns),
                   "expected " + shape(want_rows, want_columns) +
                       ": two rows, and as many entries everywhere as positions has columns");
}

template <class Matrix, class Vector>
void check_shapes(const Matrix& positions, const Matrix& normals, const Vector& friction,
                  const Vector& stiffness, const Vector& preload) {
  const Index m = positions.cols();
  check_shape("positions", positions.rows(), m, 2, m);
  check_shape("normals", normals.rows(), normals.cols(), 2, m);
  check_shape("friction", friction.rows(), friction.cols(), m, 1);
  check_shape("stiffness", stiffness.rows(), stiffness.cols(), m, 1);
  check_shape("preload", preload.rows(), preload.cols(), m, 1);
}

template <class Result, class Column>
Result by_contact(const Grasp& grasp, Index rows, const Column& column) {
  Result result(rows, static_cast<Index>(grasp.size()));
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    result.col(static_cast<Index>(i)) = column(grasp.contacts()[i]);
  }
  return result;
}

VectorX scalars(const Grasp& grasp, Rational Contact::*member) {
  VectorX result(static_cast<Index>(grasp.size()));
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    result(static_cast<Index>(i)) = grasp.contacts()[i].*member;
  }
  return result;
}

Eigen::Matrix<Rational, 2, 1> column(const Vector2& v) {
  return Eigen::Matrix<Rational, 2, 1>(v.x, v.y);
}

}  // namespace

Grasp grasp_from_eigen(const Eigen::Ref<const Eigen::MatrixXd>& positions,
                       const Eigen::Ref<const Eigen::MatrixXd>& normals,
                       const Eigen::Ref<const Eigen::VectorXd>& friction,
                       const Eigen::Ref<const Eigen::VectorXd>& stiffness,
                       const Eigen::Ref<const Eigen::VectorXd>& preload,
                       const std::string& name) {
  // Before the conversion, so that a wrong shape is not reported as a wrong entry.
  check_shapes(positions, normals, friction, stiffness, preload);
  return grasp_from_eigen(exact(positions, "positions"), exact(normals, "normals"),
                          exact(friction, "friction").col(0),
                          exact(stiffness, "stiffness").col(0),
                          exact(preload, "preload").col(0), name);
}

Grasp grasp_from_eigen(const Eigen::Ref<const MatrixX>& positions,
                       const Eigen::Ref<const MatrixX>& normals,
                       const Eigen::Ref<const VectorX>& friction,
                       const Eigen::Ref<const VectorX>& stiffness,
                       const Eigen::Ref<const VectorX>& preload, const std::string& name) {
  check_shapes(positions, normals, friction, stiffness, preload);
  std::vector<Contact> contacts;
  contacts.reserve(static_cast<std::size_t>(positions.cols()));
  for (Index i = 0; i < positions.cols(); ++i) {
    contacts.push_back({{positions(0, i), positions(1, i)},
                        {normals(0, i), normals(1, i)},
                        friction(i),
                        stiffness(i),
                        preload(i)});
  }
  return Grasp(std::move(contacts), name);
}

Matrix2X positions_matrix(const Grasp& grasp) {
  return by_contact<Matrix2X>(grasp, 2, [](const Contact& c) { return column(c.position); });
}

Matrix2X normals_matrix(const Grasp& grasp) {
  return by_contact<Matrix2X>(grasp, 2, [](const Contact& c) { return column(c.normal); });
}

VectorX friction_vector(const Grasp& grasp) {
  return scalars(grasp, &Contact::friction);
}
VectorX stiffness_vector(const Grasp& grasp) {
  return scalars(grasp, &Contact::stiffness);
}
VectorX preload_vector(const Grasp& grasp) {
  return scalars(grasp, &Contact::preload);
}

Matrix3X normal_matrix(const Grasp& grasp) {
  return by_contact<Matrix3X>(grasp, 3,
                              [](const Contact& c) { return to_eigen(normal_row(c)); });
}

Matrix3X tangent_matrix(const Grasp& grasp) {
  return by_contact<Matrix3X>(grasp, 3,
                              [](const Contact& c) { return to_eigen(tangent_row(c)); });
}

Matrix3X grasp_matrix(const Grasp& grasp) {
  Matrix3X result(3, 2 * static_cast<Index>(grasp.size()));
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const Contact& c = grasp.contacts()[i];
    result.col(2 * static_cast<Index>(i)) = to_eigen(normal_row(c));
    result.col(2 * static_cast<Index>(i) + 1) = to_eigen(tangent_row(c));
  }
  return result;
}

Twist twist_from_eigen(const Eigen::Ref<const Vector3X>& d) {
  return {d(0), d(1), d(2)};
}
Wrench wrench_from_eigen(const Eigen::Ref<const Vector3X>& w) {
  return {w(0), w(1), w(2)};
}

Twist twist_from_eigen(const Eigen::Ref<const Eigen::Vector3d>& d) {
  return twist_from_eigen(Vector3X(exact(d, "twist")));
}

Wrench wrench_from_eigen(const Eigen::Ref<const Eigen::Vector3d>& w) {
  return wrench_from_eigen(Vector3X(exact(w, "wrench")));
}

Vector3X to_eigen(const Twist& d) {
  return Vector3X(d.x, d.y, d.r);
}
Vector3X to_eigen(const Wrench& w) {
  return Vector3X(w.x, w.y, w.torque);
}

Eigen::MatrixXd to_double(const Eigen::Ref<const MatrixX>& matrix) {
  Eigen::MatrixXd result(matrix.rows(), matrix.cols());
  for (Index j = 0; j < matrix.cols(); ++j) {
    for (Index i = 0; i < matrix.rows(); ++i) result(i, j) = to_double(matrix(i, j));
  }
  return result;
}

Eigen::Vector3d to_eigen_double(const Twist& d) {
  return {to_double(d.x), to_double(d.y), to_double(d.r)};
}

Eigen::Vector3d to_eigen_double(const Wrench& w) {
  return {to_double(w.x), to_double(w.y), to_double(w.torque)};
}

}  // namespace stickslip
