#include "widgets/models/plan/plan_tree.h"

#include <algorithm>
#include <array>

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

std::span<const int> PlanTree::children(int node) const {
    const auto at = static_cast<std::size_t>(node);
    const auto first = static_cast<std::size_t>(first_child_[at]);
    const auto end = static_cast<std::size_t>(first_child_[at + 1]);
    return std::span(children_).subspan(first, end - first);
}

int PlanTree::find(std::string_view path) const {
    std::uint64_t state = plan_hash_start;
    int found = -1;
    for (std::size_t begin = 0; begin < path.size();) {
        std::size_t end = path.find('/', begin + 1);
        end = end == std::string_view::npos ? path.size() : end;
        if (found >= 0 && (*this)[found].link >= 0) // Nodes below a link are drawn elsewhere.
            state = planHash(plan_hash_start, this->path((*this)[found].link));
        state = planHash(state, path.substr(begin, end - begin));
        const auto known = by_path_.find(state);
        found = known == by_path_.end() ? -1 : known->second;
        begin = end;
    }
    if (const auto form = by_reference_.find(state); found < 0 && form != by_reference_.end())
        return form->second;
    return found;
}

std::string PlanTree::path(int node) const {
    std::vector<int> way;
    for (int at = node; at >= 0; at = (*this)[at].parent)
        way.push_back(at);
    std::string path;
    for (auto at = way.rbegin(); at != way.rend(); ++at)
        path += (*this)[*at].segment;
    return path;
}

QString PlanTree::trail(int node) const {
    QStringList names;
    for (int at = node; at >= 0; at = (*this)[at].parent)
        names.prepend((*this)[at].name);
    return names.join(QStringLiteral(" ▸ "));
}

int PlanTree::findKey(std::uint64_t key) const {
    const auto found = std::ranges::find(nodes_, key, &PlanNode::key);
    return found == nodes_.end() ? -1 : static_cast<int>(found - nodes_.begin());
}

std::vector<int> PlanTree::search(const QString& words) const {
    const QStringList parts = words.split(u' ', Qt::SkipEmptyParts);
    std::vector<int> found;
    for (int node = 0; !parts.isEmpty() && node < size(); ++node)
        if (fits((*this)[node], parts))
            found.push_back(node);
    return found;
}

} // namespace usar::widgets
