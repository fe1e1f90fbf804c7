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

/// The colors follow the thesis's figure 4.4 and are the same in both themes and in exported pictures.
const MarkStyle& styleOf(MarkKind kind);

inline constexpr std::array all_mark_kinds = {MarkKind::Path,       MarkKind::Diversion, MarkKind::LowRisk,
                                              MarkKind::HighRisk,   MarkKind::Recharge,  MarkKind::Landing,
                                              MarkKind::GoalGivenUp};

} // namespace usar::agent
