#include "widgets/models/plan/plan_tree.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <QObject>
#include <QStringList>

namespace usar::widgets {

namespace {

bool fits(const PlanNode& node, const QStringList& words) {
    const QString kind = u' ' + planKindWord(node.kind);
    return std::ranges::all_of(words, [&](const QString& word) {
        return kind.contains(u' ' + word, Qt::CaseInsensitive) || node.name.contains(word, Qt::CaseInsensitive) ||
               node.detail.contains(word, Qt::CaseInsensitive);
    });
}

} // namespace

QString planKindWord(PlanNodeKind kind) {
    constexpr std::array words{"plan",    "drive collection", "drive", "competence",
                               "element", "action pattern",   "adopt", "act",
                               "sense"}; // In the order of the kinds.
    return QObject::tr(words[static_cast<std::size_t>(kind)]);
}

std::span<const PlanNodeId> PlanTree::children(PlanNodeId node) const {
    const auto first = static_cast<std::size_t>(first_child_[node.index()]);
    const auto end = static_cast<std::size_t>(first_child_[node.index() + 1]);
    return std::span(children_).subspan(first, end - first);
}

PlanNodeId PlanTree::find(std::string_view path) const {
    std::uint64_t state = plan_hash_start;
    PlanNodeId found;
    for (std::size_t begin = 0; begin < path.size();) {
        std::size_t end = path.find('/', begin + 1);
        end = end == std::string_view::npos ? path.size() : end;
        if (found.valid() && (*this)[found].link.valid()) // Nodes below a link are drawn elsewhere.
            state = planHash(plan_hash_start, this->path((*this)[found].link));
        state = planHash(state, path.substr(begin, end - begin));
        const auto known = by_path_.find(state);
        found = known == by_path_.end() ? PlanNodeId{} : known->second;
        begin = end;
    }
    if (const auto form = by_reference_.find(state); !found.valid() && form != by_reference_.end())
        return form->second;
    return found;
}

std::string PlanTree::path(PlanNodeId node) const {
    std::vector<PlanNodeId> way;
    for (PlanNodeId at = node; at.valid(); at = (*this)[at].parent)
        way.push_back(at);
    std::string path;
    for (auto at = way.rbegin(); at != way.rend(); ++at)
        path += (*this)[*at].segment;
    return path;
}

PlanNodeId PlanTree::findKey(std::uint64_t key) const {
    const auto found = std::ranges::find(nodes_, key, &PlanNode::key);
    return found == nodes_.end() ? PlanNodeId{} : PlanNodeId{static_cast<int>(found - nodes_.begin())};
}

std::vector<PlanNodeId> PlanTree::search(const QString& words) const {
    const QStringList parts = words.split(u' ', Qt::SkipEmptyParts);
    std::vector<PlanNodeId> found;
    if (!parts.isEmpty())
        std::ranges::copy_if(nodes(), std::back_inserter(found),
                             [&](PlanNodeId node) { return fits((*this)[node], parts); });
    return found;
}

} // namespace usar::widgets
