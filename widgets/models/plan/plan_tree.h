// A plan as the tree that is drawn: each drive, element, sense and act is a node with a path; references are followed.
#pragma once

#include <cstdint>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <QString>

#include "core/base/id.h"
#include "core/posh/model/plan.h"

namespace usar::widgets {

/// Kinds of nodes. Plan is the common root if some forms are not reached by the collection.
enum class PlanNodeKind { Plan, Collection, Drive, Competence, Element, Pattern, Adopt, Act, Sense };
/// "competence": the word that the language uses, for the user.
QString planKindWord(PlanNodeKind kind);

/// How a competence, pattern or adopt that is used in several places is drawn.
enum class PlanSharing {
    Once,    ///< once, where it is first met; other places are links to it
    Expanded ///< at each place, as the engine sees it
};

/// Identifies a node of one tree. The numbers count the nodes from 0 in the order of the drawing; a default id is none.
using PlanNodeId = Id<struct PlanNodeTag>;

/// The ids from number `first` up to, but not including, number `end`.
inline auto planNodes(int first, int end) {
    return std::views::iota(first, end) | std::views::transform([](int number) { return PlanNodeId{number}; });
}

/// A node of the tree.
struct PlanNode {
    PlanNodeKind kind = PlanNodeKind::Plan;
    PlanNodeId parent{};
    int depth = 0;    ///< number of ancestors
    PlanNodeId end{}; ///< one past the last node of its subtree; nodes are stored in the order of the drawing
    int senses = 0;   ///< number of senses in its trigger or goal: the nodes directly after it, drawn inside its card
    bool in_card = false;    ///< it is one of those senses
    bool of_goal = false;    ///< it belongs to a goal, not to a trigger
    int level = -1;          ///< place of a drive or element in the order of priority, from 0
    bool has_equals = false; ///< its level has other members
    PlanNodeId link{};       ///< the node that draws this form; a link has nothing below it
    bool recursive = false;  ///< the link leads back to a node that contains it (the checks refuse such plans)
    std::uint64_t key = 0;   ///< hash of the names on the path to it: the same part of an edited plan has the same key
    std::string segment{};   ///< end of its path, after the path of its parent: "/DE:1", "/A:0/C:2"
    QString name{};          ///< for senses and acts with their arguments
    QString detail{};        ///< the rest of its line: "< 0.3", "every 2 s", "at most 3 starts", "$altitude=6.0"
    QString comment{};       ///< the string at its end, without quotes
    posh::Spot at{};         ///< place of its name in the text; line 0: none
};

/// Immutable after construction. Nothing is left out: forms that no drive reaches are drawn beside the collection.
class PlanTree {
public:
    /// Limit for PlanSharing::Expanded, because expansion may double with every level of forms. Beyond this number of
    /// nodes, further uses of a form become links.
    static constexpr int most_nodes = 200'000;

    PlanTree() = default;
    explicit PlanTree(const posh::Plan& plan, PlanSharing sharing = PlanSharing::Once);

    int size() const { return static_cast<int>(nodes_.size()); }
    bool empty() const { return nodes_.empty(); }
    const PlanNode& operator[](PlanNodeId node) const { return nodes_[node.index()]; }
    bool contains(PlanNodeId node) const { return node.valid() && node.value < size(); }
    /// All nodes in the order of the drawing.
    auto nodes() const { return planNodes(0, size()); }
    /// The rows of a card: the node itself, then the senses in its card.
    auto rows(PlanNodeId node) const { return planNodes(node.value, node.value + 1 + (*this)[node].senses); }
    /// The senses in its card.
    auto senses(PlanNodeId node) const { return planNodes(node.value + 1, node.value + 1 + (*this)[node].senses); }
    /// The card that shows the node: its parent for a sense in a card, else itself.
    PlanNodeId cardOf(PlanNodeId node) const { return (*this)[node].in_card ? (*this)[node].parent : node; }
    /// Number of nodes below its card, which do not include the senses in it.
    int countBelow(PlanNodeId node) const { return (*this)[node].end.value - node.value - 1 - (*this)[node].senses; }
    /// The cards directly below the node, in order, without the senses inside its own card.
    std::span<const PlanNodeId> children(PlanNodeId node) const;
    /// True if some forms were not expanded because of `most_nodes`.
    bool truncated() const { return truncated_; }

    /// The node of an engine's path, even if the path leads through a link; none if the tree has none. Linear in the
    /// length of the path.
    PlanNodeId find(std::string_view path) const;
    /// The engine's path of the node.
    std::string path(PlanNodeId node) const;
    /// The node with this key, if there is one. Parts of the same name in one place differ by their order.
    PlanNodeId findKey(std::uint64_t key) const;

    /// Finds the nodes for which every word either begins a word of the node's kind ("sense", "competence") or is
    /// contained in its name or detail, ignoring case. Empty without words.
    std::vector<PlanNodeId> search(const QString& words) const;

private:
    friend class PlanTreeBuilder;

    std::vector<PlanNode> nodes_;
    std::vector<PlanNodeId> children_;
    std::vector<int> first_child_; ///< index into children_; has one entry more than there are nodes
    std::unordered_map<std::uint64_t, PlanNodeId> by_path_;
    std::unordered_map<std::uint64_t, PlanNodeId> by_reference_; ///< forms by the path of what refers to them: "…/A:0"
    bool truncated_ = false;
};

/// FNV-1a hash, which can be updated while a path is read.
constexpr std::uint64_t plan_hash_start = 14695981039346656037ULL;
constexpr std::uint64_t planHash(std::uint64_t state, std::string_view text) {
    for (const char c : text)
        state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return state;
}

} // namespace usar::widgets
