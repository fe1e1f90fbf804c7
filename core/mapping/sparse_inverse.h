// Parts of the inverse of a sparse matrix, without making all of it.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace usar::mapping {

/// The 4 x 4 blocks on the diagonal of the inverse of a symmetric, positive definite matrix, of which the lower half is
/// given; its size is a multiple of four, and within the blocks it has no zeros. By the recursion of Takahashi, Fagan
/// and Chen (1973), which computes the inverse only where the Cholesky factor has entries. Empty if the matrix is not
/// positive definite.
std::vector<Eigen::Matrix4d> diagonalBlocksOfInverse(const Eigen::SparseMatrix<double>& lower);

} // namespace usar::mapping
