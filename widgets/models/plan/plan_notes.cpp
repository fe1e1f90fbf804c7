#include "widgets/models/plan/plan_notes.h"

#include <string>

#include "core/agent/posh/posh_binding.h"

namespace usar::widgets {

std::vector<PlanNote> notesOf(const posh::Plan& plan) {
    const std::string remark = agent::clockRemark(plan);
    if (remark.empty())
        return {};
    const posh::Collection& collection = *posh::collectionOf(plan);
    posh::Spot at = collection.at;
    at.length = static_cast<std::uint32_t>(1 + collection.keyword.size()); // Only "(RDC", not the whole collection.
    return {
        {at, QStringLiteral("%1:%2: note N501: %3").arg(at.line).arg(at.column).arg(QString::fromStdString(remark))}};
}

} // namespace usar::widgets
