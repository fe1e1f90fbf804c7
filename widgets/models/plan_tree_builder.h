// Builds the tree of a plan from its forms.
#pragma once

#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// For a single use. Works with its own stack, so the depth of a plan is not limited.
class PlanTreeBuilder {
public:
    PlanTreeBuilder(PlanTree& tree, const posh::Plan& plan, PlanSharing sharing);
    void build();

private:
    /// The following structs are the kinds of tasks: draw a call, a drive or element, a sense as a step, a form as a
    /// root, or leave a form.
    struct Reference {
        const posh::Call* call;
        std::string segment; ///< "/A:2"
    };
    struct Member {
        std::variant<const posh::Drive*, const posh::Element*> part;
        int level;
        bool has_equals;
        int number;
    };
    struct SenseStep {
        const posh::SenseTest* test;
        int number;
    };
    struct Root {
        std::size_t form; ///< index in the plan's forms
    };
    struct Close {
        std::size_t form;
    };
    struct Task {
        int parent;
        std::variant<Reference, Member, SenseStep, Root, Close> what;
    };

    void indexForms();
    /// Forms that no collection leads to; each is drawn once as a root.
    std::vector<std::size_t> unreachedForms() const;
    void markReachable(std::size_t form, std::vector<bool>& reached) const;
    void run(const Task& task);
    void addReference(int parent, const Reference& reference);
    void addMember(int parent, const Member& member);
    void addSenseStep(int parent, const SenseStep& step);
    void addForm(int parent, std::size_t form, const std::string& before);
    void openForm(int node, std::size_t form);
    void addSenses(int parent, const posh::Senses& senses, bool of_goal);
    int add(PlanNode node);
    /// Schedules a task; tasks run depth-first in the order in which they were scheduled.
    void later(int parent, decltype(Task::what) what) { coming_.push_back({parent, std::move(what)}); }
    void pushComing();
    /// Sets the end of each subtree and the children of each card.
    void finish();

    PlanTree& tree_;
    const posh::Plan& plan_;
    PlanSharing sharing_;
    std::unordered_map<std::string, std::size_t> form_of_name_;
    std::vector<int> number_of_form_; ///< by form: its number among forms of its kind
    std::vector<int> drawn_at_;       ///< by form: the node that draws it, or -1
    /// By form: the node that is being expanded now, or -1.
    std::vector<int> open_at_;
    std::vector<std::uint64_t> path_hash_;
    std::vector<Task> stack_;
    std::vector<Task> coming_; ///< tasks that the running task has scheduled, in order
    /// Number of nodes so far by key of their names.
    std::unordered_map<std::uint64_t, int> seen_keys_;
};

} // namespace usar::widgets
