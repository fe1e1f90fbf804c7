// A test of paired differences that may be looked at after each pair, so that a campaign can stop when it is decided.
#pragma once

#include <cstddef>

namespace usar::campaign {

enum class SequentialVerdict { Undecided, Better, Worse };

/// Bets on the signs of the differences. A pair in which the candidate is better by more than the margin is a win, one
/// in which it is worse by more than the margin is a loss; others say nothing. If wins are at most as likely as losses,
/// the gambler who bets on wins is a supermartingale, whatever his stakes: that his wealth ever reaches 1 / a has a
/// probability of at most a (Ville 1939; Waudby-Smith and Ramdas 2024). He spreads his wealth evenly over all chances
/// of a win from 1/2 to 1, which has a closed form; another bets on losses in the same way. Each may be wrong with half
/// of `alpha`, so a verdict is wrong with at most `alpha`, however often somebody looks and whenever the campaign
/// stops. A verdict stays once it is given. A plain value; not for use by several threads at once.
class SequentialTest {
public:
    /// No verdict is given before this many pairs, ties included: a lucky start convinces nobody.
    static constexpr std::size_t least_pairs = 20;

    explicit SequentialTest(double margin, double alpha = 0.05) : margin_(margin), alpha_(alpha) {}

    /// Takes the next pair. `gain` is positive where the candidate is better.
    void add(double gain);

    SequentialVerdict verdict() const { return verdict_; }
    std::size_t pairs() const { return wins_ + losses_ + ties_; }
    std::size_t wins() const { return wins_; }
    std::size_t losses() const { return losses_; }
    /// The natural logarithm of the wealth of who bets on wins, and on losses. Both start with 0.
    double evidenceForBetter() const;
    double evidenceForWorse() const;

private:
    double margin_;
    double alpha_;
    std::size_t wins_ = 0;
    std::size_t losses_ = 0;
    std::size_t ties_ = 0;
    SequentialVerdict verdict_ = SequentialVerdict::Undecided;
};

} // namespace usar::campaign
