// Builds the tree of a plan from its forms.
#pragma once

#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// For a single use. Works with its own stack, so the depth of a plan is not limited.
class PlanTreeBuilder {
public:
    PlanTreeBuilder(PlanTree& tree, const posh::Plan& plan, PlanSharing sharing);
    /// Fills the tree.
    void build();

private:
    /// The following structs are the kinds of tasks: draw a call, a drive or element, a sense as a step, a form as a
    /// root, or leave a form.
    struct Reference {
        const posh::Call* call;
        std::string segment; ///< "/A:2"
    };
    /// A drive of a collection or an element of a competence.
    struct Member {
        const posh::Member* part;
        int level;
        bool has_equals;
        /// Number among all members of the form.
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
    /// Marks this form and every form that it leads to.
    void markReachable(std::size_t form, std::vector<bool>& reached) const;
    /// Performs one task.
    void run(const Task& task);
    void addReference(int parent, const Reference& reference);
    void addMember(int parent, const Member& member);
    void addSenseStep(int parent, const SenseStep& step);
    /// Adds the node of a form, or a link to it; `before` is the part of its path before the form's own segment.
    void addForm(int parent, std::size_t form, const std::string& before);
    /// Schedules the contents of a form.
    void openForm(int node, std::size_t form);
    /// Adds the senses of a trigger or goal to the card of `parent`.
    void addSenses(int parent, const posh::Senses& senses, bool of_goal);
    /// Appends a node and sets its depth, key and path; returns its number.
    int add(PlanNode node);
    /// Schedules a task; tasks run depth-first in the order in which they were scheduled.
    void later(int parent, decltype(Task::what) what) { coming_.push_back({parent, std::move(what)}); }
    /// Moves the scheduled tasks to the stack, so that they run before older ones.
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
