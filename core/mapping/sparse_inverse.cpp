#include "core/mapping/sparse_inverse.h"

#include <algorithm>

#include <Eigen/SparseCholesky>

namespace usar::mapping {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<Sparse, Eigen::Lower>;

/// The entries of the inverse at the entries of the factor: `below` has those below the diagonal.
struct PartOfInverse {
    Sparse below;
    Eigen::VectorXd diagonal;

    double at(Eigen::Index row, Eigen::Index column) const {
        return row == column ? diagonal[row] : below.coeff(std::max(row, column), std::min(row, column));
    }
};

/// Computes the columns from the last to the first: each needs only entries of later ones.
PartOfInverse partOfInverse(const Cholesky& factor) {
    const Sparse lower = factor.matrixL().nestedExpression();
    PartOfInverse inverse{lower, factor.vectorD().cwiseInverse()};
    Eigen::VectorXd of_column = Eigen::VectorXd::Zero(lower.rows()), sums = of_column;
    std::vector<char> in_column(static_cast<std::size_t>(lower.rows()), 0);
    for (Eigen::Index j = lower.cols() - 1; j >= 0; --j) {
        for (Sparse::InnerIterator entry(lower, j); entry; ++entry) {
            of_column[entry.row()] = entry.value();
            sums[entry.row()] = 0.0;
            in_column[static_cast<std::size_t>(entry.row())] = 1;
        }
        for (Sparse::InnerIterator entry(lower, j); entry; ++entry) {
            const Eigen::Index k = entry.row();
            double sum = entry.value() * inverse.diagonal[k];
            for (Sparse::InnerIterator known(inverse.below, k); known; ++known) {
                if (!in_column[static_cast<std::size_t>(known.row())])
                    continue;
                sum += of_column[known.row()] * known.value();
                sums[known.row()] += entry.value() * known.value();
            }
            sums[k] += sum;
        }
        for (Sparse::InnerIterator entry(inverse.below, j); entry; ++entry) {
            const Eigen::Index row = entry.row();
            entry.valueRef() = -sums[row];
            inverse.diagonal[j] += of_column[row] * sums[row];
            in_column[static_cast<std::size_t>(row)] = 0;
        }
    }
    return inverse;
}

} // namespace

std::vector<Eigen::Matrix4d> diagonalBlocksOfInverse(const Sparse& lower) {
    const Cholesky factor(lower);
    if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
        return {};
    const PartOfInverse inverse = partOfInverse(factor);
    std::vector<Eigen::Matrix4d> blocks(static_cast<std::size_t>(lower.rows() / 4));
    for (std::size_t block = 0; block < blocks.size(); ++block)
        for (Eigen::Index a = 0; a < 4; ++a)
            for (Eigen::Index b = 0; b < 4; ++b) {
                const auto first = static_cast<Eigen::Index>(4 * block);
                blocks[block](a, b) =
                    inverse.at(factor.permutationP().indices()[first + a], factor.permutationP().indices()[first + b]);
            }
    return blocks;
}

} // namespace usar::mapping
