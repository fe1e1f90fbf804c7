#include "core/agent/mark_style.h"

namespace usar::agent {

const MarkStyle& styleOf(MarkKind kind) {
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
