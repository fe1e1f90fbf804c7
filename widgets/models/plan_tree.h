// A plan as the tree that is drawn: every drive, element, sense and act a node with its path, references followed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <QString>

#include "core/posh/plan.h"

namespace usar::widgets {

enum class PlanNodeKind { Plan, Collection, Drive, Competence, Element, Pattern, Adopt, Act, Sense };
/// "competence": the word of the language, for people.
QString planKindWord(PlanNodeKind kind);

/// What becomes of a competence, pattern or adopt that is used at several places.
enum class PlanSharing {
    Once,    ///< drawn where it is met first; later places are links to it
    Expanded ///< drawn at each place, as the engine sees it
};

/// Node numbers are those of the tree; -1 is none.
struct PlanNode {
    PlanNodeKind kind = PlanNodeKind::Plan;
    int parent = -1;
    int depth = 0;
    int end = 0;             ///< one past the last node below it: nodes stand in the order of the drawing
    int senses = 0;          ///< of its trigger or goal: the nodes right behind it, drawn inside its card
    bool in_card = false;    ///< it is one of those
    bool of_goal = false;    ///< it asks for a goal, not for a trigger
    int level = -1;          ///< of a drive or element: its place in the order of priority, from 0
    bool has_equals = false; ///< its level has several members
    int link = -1;           ///< the node where this form is drawn; nothing is below a link
    bool recursive = false;  ///< the link leads back to what this stands in (the checks refuse such plans)
    std::uint64_t key = 0;   ///< of the names on the way to it: the same part of a changed plan has the same one
    std::string segment;     ///< what its path has behind that of its parent: "/DE:1", "/A:0/C:2"
    QString name;            ///< of a sense with its arguments
    QString detail;          ///< the rest of its line: "< 0.3", "every 2 s", "at most 3 starts", "$altitude=6.0"
    QString comment;         ///< the string at its end, without quotes
    posh::Spot at;           ///< of its name
};

/// Values, made at once; nothing is ever left out: what no drive reaches stands beside the collection.
class PlanTree {
public:
    /// Expanding doubles with every level of forms that refer to others twice. Beyond so many nodes forms are links
    /// even where they should be expanded.
    static constexpr int most_nodes = 200'000;

    PlanTree() = default;
    explicit PlanTree(const posh::Plan& plan, PlanSharing sharing = PlanSharing::Once);

    int size() const { return static_cast<int>(nodes_.size()); }
    bool empty() const { return nodes_.empty(); }
    const PlanNode& operator[](int node) const { return nodes_[static_cast<std::size_t>(node)]; }
    /// The cards below it, in their order; its senses are none of them.
    std::span<const int> children(int node) const;
    /// Expanding was given up somewhere.
    bool truncated() const { return truncated_; }

    /// The node of a path of the engine, also of one that leads through a link; -1 where there is none. Linear in the
    /// length of the path.
    int find(std::string_view path) const;
    std::string path(int node) const;
    /// "robot ▸ work ▸ pick-up ▸ grab": for people.
    QString trail(int node) const;
    /// -1 where no node has this key. Namesakes at one place are told apart by their order.
    int findKey(std::uint64_t key) const;

    /// Every word must begin a word of the node's kind ("sense", "competence") or stand in its name or details,
    /// whatever the case. Nothing for no words.
    std::vector<int> search(const QString& words) const;

private:
    friend class PlanTreeBuilder;

    std::vector<PlanNode> nodes_;
    std::vector<int> children_;
    std::vector<int> first_child_; ///< in children_; one more than there are nodes
    std::unordered_map<std::uint64_t, int> by_path_;
    std::unordered_map<std::uint64_t, int> by_reference_; ///< forms by the path of what refers to them: "…/A:0"
    bool truncated_ = false;
};

/// FNV-1a, so that a path can be looked up while it is read.
constexpr std::uint64_t plan_hash_start = 14695981039346656037ULL;
constexpr std::uint64_t planHash(std::uint64_t state, std::string_view text) {
    for (const char c : text)
        state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return state;
}

} // namespace usar::widgets
