// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps, twists and wrenches from and to Eigen. The only header that includes Eigen.
///
/// Doubles become the dyadic rationals that they are: 0.1 is 3602879701896397/2^55, so unit
/// normals in double have, exactly, a length near 1 that is seldom rational. Preloaded grasps
/// from doubles therefore need snap_normals.
///
/// Products, sums, transposes and comparisons of Rational matrices are exact. Decompositions
/// that pivot by magnitude and compare with an epsilon are not meant for Rational.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>
#include <string>

#include "stickslip/core/contact_row.hpp"

namespace stickslip {

/// \{ Matrices and column vectors of exact numbers; X is a size known at run time.
using MatrixX = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;
using Matrix2X = Eigen::Matrix<Rational, 2, Eigen::Dynamic>;
using Matrix3X = Eigen::Matrix<Rational, 3, Eigen::Dynamic>;
using VectorX = Eigen::Matrix<Rational, Eigen::Dynamic, 1>;
using Vector3X = Eigen::Matrix<Rational, 3, 1>;
/// \}

/// \{ \brief The grasp whose contact i has column i of `positions` and `normals` (2 x m each)
/// and entry i of `friction`, `stiffness` and `preload` (m each). Throws InputError naming the
/// argument ("positions", when the shapes disagree), the entry ("normals(0,3)", NaN or
/// infinite) or, when a value breaks a requirement of Contact, "contacts[i].<member>". O(m).
Grasp grasp_from_eigen(const Eigen::Ref<const Eigen::MatrixXd>& positions,
                       const Eigen::Ref<const Eigen::MatrixXd>& normals,
                       const Eigen::Ref<const Eigen::VectorXd>& friction,
                       const Eigen::Ref<const Eigen::VectorXd>& stiffness,
                       const Eigen::Ref<const Eigen::VectorXd>& preload,
                       const std::string& name = {});
Grasp grasp_from_eigen(const Eigen::Ref<const MatrixX>& positions,
                       const Eigen::Ref<const MatrixX>& normals,
                       const Eigen::Ref<const VectorX>& friction,
                       const Eigen::Ref<const VectorX>& stiffness,
                       const Eigen::Ref<const VectorX>& preload, const std::string& name = {});
/// \}

/// \{ The arguments of grasp_from_eigen again, exactly.
Matrix2X positions_matrix(const Grasp& grasp);
Matrix2X normals_matrix(const Grasp& grasp);
VectorX friction_vector(const Grasp& grasp);
VectorX stiffness_vector(const Grasp& grasp);
VectorX preload_vector(const Grasp& grasp);
/// \}

/// Columns N_1, N_2, ... (contact_row.hpp), of the normals as given, whatever their length.
Matrix3X normal_matrix(const Grasp& grasp);
/// Columns T_1, T_2, ... (contact_row.hpp).
Matrix3X tangent_matrix(const Grasp& grasp);
/// The paper's grasp map G, its Eq. 1: 3 x 2m, columns N_1, T_1, N_2, T_2, ...: G c is the
/// wrench of the contact forces c = (a_1, b_1, a_2, b_2, ...) and G^T d the motions of the
/// contacts.
Matrix3X grasp_matrix(const Grasp& grasp);

/// \{ \brief (x, y, r) and (x, y, torque), exactly. From doubles: throw InputError naming
/// "twist(i)" or "wrench(i)" for NaN and infinities.
Twist twist_from_eigen(const Eigen::Ref<const Eigen::Vector3d>& d);
Twist twist_from_eigen(const Eigen::Ref<const Vector3X>& d);
Wrench wrench_from_eigen(const Eigen::Ref<const Eigen::Vector3d>& w);
Wrench wrench_from_eigen(const Eigen::Ref<const Vector3X>& w);
Vector3X to_eigen(const Twist& d);
Vector3X to_eigen(const Wrench& w);
/// \}

/// \{ Each entry to_double: within one unit in the last place.
Eigen::MatrixXd to_double(const Eigen::Ref<const MatrixX>& matrix);
Eigen::Vector3d to_eigen_double(const Twist& d);
Eigen::Vector3d to_eigen_double(const Wrench& w);
/// \}

}  // namespace stickslip
