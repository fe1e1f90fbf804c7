// How the marks on a map look and what they are called, wherever they are drawn or written.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/agent/published.h"

namespace usar::agent {

enum class MarkShape { Dot, Diamond, Disc, Triangle, Square, Ring, Cross };

struct MarkStyle {
    std::uint32_t rgb = 0;   ///< 0xrrggbb
    std::string_view name{}; ///< for people: "Low risk"
    std::string_view word{}; ///< for files: "low_risk"
    MarkShape shape = MarkShape::Dot;
};

inline constexpr std::array all_mark_kinds = {MarkKind::Path,       MarkKind::Diversion, MarkKind::LowRisk,
                                              MarkKind::HighRisk,   MarkKind::Recharge,  MarkKind::Landing,
                                              MarkKind::GoalGivenUp};

/// The colors follow the thesis's figure 4.4 and are the same in both themes and in exported pictures.
inline const MarkStyle& styleOf(MarkKind kind) {
    static constexpr std::array<MarkStyle, all_mark_kinds.size()> styles{{
        {0x23c552, "Path", "path", MarkShape::Dot},
        {0x3d7eff, "Diversion", "diversion", MarkShape::Diamond},
        {0xff9500, "Low risk", "low_risk", MarkShape::Disc},
        {0xff2d2d, "High risk", "high_risk", MarkShape::Triangle},
        {0xffdd00, "Recharge", "recharge", MarkShape::Square},
        {0xb25cff, "Landing", "landing", MarkShape::Ring},
        {0xf2f2f2, "Goal given up", "goal_given_up", MarkShape::Cross},
    }};
    return styles[static_cast<std::size_t>(kind)];
}

} // namespace usar::agent
