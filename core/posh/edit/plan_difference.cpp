#include "core/posh/edit/plan_difference.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "core/posh/language/plan_writer.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

constexpr std::size_t most_steps_compared = 2000;

/// A drive or an element with its parts as text.
struct MemberView {
    PlanPart part;
    const Name* name = nullptr;
    std::string trigger;
    std::string action;
    std::string limit; ///< frequency or retries
    std::string comment;
    std::size_t place = 0; ///< position in order of priority, counting from 1

    std::string content() const { return trigger + '\n' + action + '\n' + limit; }
};

/// Returns what a function of plan_writer.h appends, without the blank before it.
template <class Part>
std::string textOf(void (*append)(std::string&, const Part&), const Part& part) {
    std::string text;
    append(text, part);
    return text.starts_with(' ') ? text.substr(1) : text;
}

std::string sensesText(const Senses& senses) {
    return senses.empty() ? "" : textOf(appendSenses, senses);
}

std::vector<MemberView> membersOf(const Form& form, std::size_t number) {
    std::vector<MemberView> found;
    const Levels* const levels = levelsIn(form);
    for (std::size_t level = 0; levels && level < levels->size(); ++level)
        for (std::size_t i = 0; i < (*levels)[level].size(); ++i) {
            const Member& member = (*levels)[level][i];
            found.push_back({memberPart(number, level, i), &member.name, sensesText(member.trigger),
                             textOf(appendCall, member.action),
                             textOf(appendInterval, member.frequency) + textOf(appendComment, member.retries),
                             textOf(appendComment, member.comment), found.size() + 1});
        }
    return found;
}

/// Finds a longest increasing subsequence; the result is true for each number that belongs to it.
std::vector<bool> risingRow(const std::vector<std::size_t>& numbers) {
    std::vector<std::size_t> ends;
    std::vector<std::size_t> before(numbers.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto place = std::lower_bound(ends.begin(), ends.end(), numbers[i],
                                            [&](std::size_t end, std::size_t number) { return numbers[end] < number; });
        if (place != ends.begin())
            before[i] = *(place - 1);
        if (place == ends.end())
            ends.push_back(i);
        else
            *place = i;
    }
    std::vector<bool> belongs(numbers.size(), false);
    for (std::size_t i = ends.empty() ? numbers.size() : ends.back(); i < numbers.size(); i = before[i])
        belongs[i] = true;
    return belongs;
}

std::string memberText(const Form& form, const MemberView& member) {
    const bool is_drive = std::holds_alternative<Collection>(form);
    return is_drive ? "drive " + inQuotes(member.name->text)
                    : "element " + inQuotes(member.name->text) + " of " + inQuotes(nameOf(form).text);
}

class Comparer {
public:
    Comparer(const Plan& before, const Plan& after) : old_(before), new_(after), renamed_(before) {}

    std::vector<PlanChange> run() {
        matchForms();
        renameCalls();
        compareDocumentation();
        for (std::size_t i = 0; i < new_.forms.size(); ++i)
            if (const auto same = old_of_new_[i])
                compareForms(*same, i);
            else
                tell(ChangeKind::Added, std::nullopt, formPart(i), formText(new_.forms[i]) + " added");
        for (std::size_t i = 0; i < old_.forms.size(); ++i)
            if (!new_of_old_[i])
                tell(ChangeKind::Removed, formPart(i), std::nullopt, formText(old_.forms[i]) + " removed");
        tellMembers();
        return std::move(changes_);
    }

private:
    static std::string formText(const Form& form) { return kindWord(form) + inQuotes(nameOf(form).text); }

    void tell(ChangeKind kind, std::optional<PlanPart> before, std::optional<PlanPart> after, std::string line) {
        PlanChange change{kind, before, after, {}, std::move(line)};
        if (const Name* const name = after ? nameOf(new_, *after) : nullptr)
            change.after_at = name->at;
        changes_.push_back(std::move(change));
    }

    void match(std::size_t before, std::size_t after) {
        new_of_old_[before] = after;
        old_of_new_[after] = before;
    }

    /// Pairs the forms of both plans by kind and name, and those left over by kind and content. Two collections always
    /// match, because a plan has only one.
    void matchForms() {
        new_of_old_.assign(old_.forms.size(), std::nullopt);
        old_of_new_.assign(new_.forms.size(), std::nullopt);
        std::map<std::pair<std::size_t, std::string>, std::vector<std::size_t>> by_name;
        for (std::size_t i = old_.forms.size(); i-- > 0;)
            by_name[{old_.forms[i].index(), nameOf(old_.forms[i]).text}].push_back(i);
        for (std::size_t i = 0; i < new_.forms.size(); ++i) {
            const auto found = by_name.find({new_.forms[i].index(), nameOf(new_.forms[i]).text});
            if (found == by_name.end() || found->second.empty())
                continue;
            match(found->second.back(), i);
            found->second.pop_back();
        }
        for (std::size_t i = 0; i < new_.forms.size(); ++i)
            for (std::size_t j = 0; j < old_.forms.size() && !old_of_new_[i]; ++j)
                if (!new_of_old_[j] && areTheSameButForTheName(old_.forms[j], new_.forms[i]))
                    match(j, i);
    }

    static bool areTheSameButForTheName(const Form& a, const Form& b) {
        if (a.index() != b.index())
            return false;
        if (std::holds_alternative<Collection>(a))
            return true;
        const auto bareWords = [](const Form& form) {
            const std::vector<MemberView> members = membersOf(form, 0);
            std::string words;
            for (const MemberView& member : members)
                words += member.name->text + '\n' + member.content() + '\n';
            forEachCall(form, [&](const Call& call, bool) { words += textOf(appendCall, call) + '\n'; });
            return words;
        };
        return bareWords(a) == bareWords(b);
    }

    /// Renames the calls of renamed forms, so that such a call does not count as a change itself.
    void renameCalls() {
        std::unordered_map<std::string, std::string> names;
        for (std::size_t i = 0; i < old_.forms.size(); ++i)
            if (new_of_old_[i] && nameOf(old_.forms[i]).text != nameOf(new_.forms[*new_of_old_[i]]).text)
                names[nameOf(old_.forms[i]).text] = nameOf(new_.forms[*new_of_old_[i]]).text;
        for (Form& form : renamed_.forms)
            forEachCall(form, [&names](Call& call, bool is_sense) {
                if (const auto found = names.find(call.name.text); !is_sense && found != names.end())
                    call.name.text = found->second;
            });
    }

    void compareDocumentation() {
        const auto& before = old_.documentation;
        const auto& after = new_.documentation;
        const auto saysTheSame = [](const Documentation& a, const Documentation& b) {
            return a.title.value == b.title.value && a.author.value == b.author.value && a.text.value == b.text.value;
        };
        if (before.has_value() == after.has_value() && (!before || saysTheSame(*before, *after)))
            return;
        const ChangeKind kind = !before ? ChangeKind::Added : !after ? ChangeKind::Removed : ChangeKind::Changed;
        const char* const what = !before ? "added" : !after ? "removed" : "changed";
        changes_.push_back(
            {kind, std::nullopt, std::nullopt, after ? after->at : Spot(), std::string("documentation ") + what});
    }

    void compareForms(std::size_t before, std::size_t after) {
        const Form& was = renamed_.forms[before];
        const Form& is = new_.forms[after];
        if (nameOf(was).text != nameOf(is).text)
            tell(ChangeKind::Renamed, formPart(before), formPart(after),
                 formText(was) + " renamed to " + inQuotes(nameOf(is).text));
        const auto compare = [&](const char* what, const std::string& old_words, const std::string& new_words) {
            compareWords(formText(is), what, old_words, new_words, formPart(before), formPart(after));
        };
        std::visit(
            [&]<class Kind>(const Kind& now) {
                const Kind& then = std::get<Kind>(was);
                if constexpr (requires { now.goal; })
                    compare("goal", sensesText(then.goal), sensesText(now.goal));
                if constexpr (requires { now.formals; })
                    compare("parameters", textOf(appendFormals, then.formals), textOf(appendFormals, now.formals));
                if constexpr (requires { now.time_limit; })
                    compare("time", textOf(appendInterval, then.time_limit), textOf(appendInterval, now.time_limit));
                if constexpr (requires { now.comment; })
                    compare("comment", textOf(appendComment, then.comment), textOf(appendComment, now.comment));
                if constexpr (requires { now.adopted; })
                    compare("act", textOf(appendCall, then.adopted), textOf(appendCall, now.adopted));
                if constexpr (requires { now.keyword; })
                    compare("kind", then.kind == now.kind ? "" : keywordText(then),
                            then.kind == now.kind ? "" : keywordText(now));
                if constexpr (requires { now.steps; })
                    compareSteps(then.steps, now.steps, before, after);
                if constexpr (requires { now.levels; })
                    compareMembers(before, after);
            },
            is);
    }

    void compareWords(const std::string& whose, const char* what, const std::string& before, const std::string& after,
                      const PlanPart& before_part, const PlanPart& after_part) {
        if (before == after)
            return;
        const auto shown = [](const std::string& words) { return words.empty() ? std::string("none") : words; };
        tell(ChangeKind::Changed, before_part, after_part,
             whose + ": " + what + " was " + shown(before) + ", is " + shown(after));
    }

    /// Compares the steps of two patterns. Of the steps that both have, those in the same relative order stayed and the
    /// others moved.
    void compareSteps(const std::vector<Step>& before, const std::vector<Step>& after, std::size_t old_form,
                      std::size_t new_form) {
        std::map<std::string, std::vector<std::size_t>> places;
        for (std::size_t i = before.size(); i-- > 0;)
            places[textOf(appendStep, before[i])].push_back(i);
        std::vector<std::size_t> from;
        std::vector<std::size_t> to;
        const std::string whose = formText(new_.forms[new_form]);
        const auto part = [](const Step& step, std::size_t form, std::size_t index) {
            return PlanPart{std::holds_alternative<Call>(step) ? PartKind::Action : PartKind::Sense, form, 0, 0, index};
        };
        for (std::size_t i = 0; i < after.size(); ++i) {
            auto& same = places[textOf(appendStep, after[i])];
            if (same.empty()) {
                tell(ChangeKind::Added, std::nullopt, part(after[i], new_form, i),
                     whose + ": step " + textOf(appendStep, after[i]) + " added");
                continue;
            }
            from.push_back(same.back());
            to.push_back(i);
            same.pop_back();
        }
        const std::vector<bool> stayed = risingRow(from);
        for (std::size_t i = 0; i < from.size() && from.size() < most_steps_compared; ++i)
            if (!stayed[i])
                tell(ChangeKind::Moved, part(before[from[i]], old_form, from[i]), part(after[to[i]], new_form, to[i]),
                     whose + ": step " + textOf(appendStep, after[to[i]]) + " moved from place " +
                         std::to_string(from[i] + 1) + " to place " + std::to_string(to[i] + 1));
        for (const auto& [words, left] : places)
            for (const std::size_t i : left)
                tell(ChangeKind::Removed, part(before[i], old_form, i), std::nullopt,
                     whose + ": step " + words + " removed");
    }

    void compareMembers(std::size_t before, std::size_t after) {
        const Form& form = new_.forms[after];
        std::map<std::string, std::vector<MemberView>> by_name;
        std::vector<MemberView> old_members = membersOf(renamed_.forms[before], before);
        for (auto member = old_members.rbegin(); member != old_members.rend(); ++member)
            by_name[member->name->text].push_back(*member);
        std::vector<std::pair<MemberView, MemberView>> pairs;
        std::vector<MemberView> left;
        for (const MemberView& member : membersOf(form, after)) {
            auto& same = by_name[member.name->text];
            if (same.empty()) {
                left.push_back(member);
                continue;
            }
            pairs.emplace_back(same.back(), member);
            same.pop_back();
        }
        for (const MemberView& member : left) {
            const auto same = std::find_if(by_name.begin(), by_name.end(), [&member](const auto& entry) {
                return !entry.second.empty() && entry.second.back().content() == member.content();
            });
            if (same == by_name.end()) {
                come_.push_back(member);
                continue;
            }
            const MemberView was = same->second.back();
            same->second.pop_back();
            tell(ChangeKind::Renamed, was.part, member.part,
                 memberText(renamed_.forms[before], was) + " renamed to " + inQuotes(member.name->text));
            pairs.emplace_back(was, member);
        }
        for (const auto& [name, members] : by_name)
            gone_.insert(gone_.end(), members.begin(), members.end());
        std::ranges::sort(pairs, {}, [](const auto& pair) { return pair.second.place; });
        for (const auto& [was, is] : pairs)
            compareMember(was, is, memberText(form, is));
        compareOrder(pairs, form);
    }

    void compareMember(const MemberView& was, const MemberView& is, const std::string& whose) {
        const bool is_drive = std::holds_alternative<Collection>(new_.forms[is.part.form]);
        compareWords(whose, "trigger", was.trigger, is.trigger, was.part, is.part);
        compareWords(whose, "act", was.action, is.action, was.part, is.part);
        compareWords(whose, is_drive ? "frequency" : "starts", was.limit, is.limit, was.part, is.part);
        compareWords(whose, "comment", was.comment, is.comment, was.part, is.part);
    }

    void compareOrder(const std::vector<std::pair<MemberView, MemberView>>& pairs, const Form& form) {
        std::vector<std::size_t> places;
        for (const auto& [was, is] : pairs)
            places.push_back(was.place);
        const std::vector<bool> stayed = risingRow(places);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto& [was, is] = pairs[i];
            const std::string whose = memberText(form, is);
            if (!stayed[i])
                tell(ChangeKind::Moved, was.part, is.part,
                     whose + " moved from place " + std::to_string(was.place) + " to place " +
                         std::to_string(is.place));
        }
        for (std::size_t i = 1; i < pairs.size();
             ++i) { // Has each member joined or left the level of the one before it?
            const bool were_equal = pairs[i - 1].first.part.level == pairs[i].first.part.level;
            const bool are_equal = pairs[i - 1].second.part.level == pairs[i].second.part.level;
            if (were_equal != are_equal)
                tell(ChangeKind::Moved, pairs[i].first.part, pairs[i].second.part,
                     memberText(form, pairs[i].second) + (are_equal ? " is an equal of " : " is no equal of ") +
                         inQuotes(pairs[i - 1].second.name->text) + " now");
        }
    }

    /// Reports members that were added or removed. A member that left one form and appears in another with the same
    /// name and action has moved.
    void tellMembers() {
        for (const MemberView& member : come_) {
            const auto from = std::ranges::find_if(gone_, [&member](const MemberView& other) {
                return other.name->text == member.name->text && other.action == member.action;
            });
            const Form& form = new_.forms[member.part.form];
            const std::string whose = memberText(form, member);
            if (from == gone_.end()) {
                tell(ChangeKind::Added, std::nullopt, member.part, whose + " added");
                continue;
            }
            tell(ChangeKind::Moved, from->part, member.part,
                 (std::holds_alternative<Collection>(form) ? "drive " : "element ") + inQuotes(member.name->text) +
                     " moved from " + inQuotes(nameOf(old_.forms[from->part.form]).text) + " to " +
                     inQuotes(nameOf(form).text));
            compareMember(*from, member, whose);
            gone_.erase(from);
        }
        for (const MemberView& member : gone_)
            tell(ChangeKind::Removed, member.part, std::nullopt,
                 memberText(old_.forms[member.part.form], member) + " removed");
    }

    const Plan& old_;
    const Plan& new_;
    Plan renamed_; ///< the old plan, in which calls of renamed forms have the new names
    std::vector<std::optional<std::size_t>> new_of_old_;
    std::vector<std::optional<std::size_t>> old_of_new_;
    std::vector<MemberView> gone_; ///< members that are no longer in their form
    std::vector<MemberView> come_; ///< members that are new in their form
    std::vector<PlanChange> changes_;
};

} // namespace

std::vector<PlanChange> planDifference(const Plan& before, const Plan& after) {
    return Comparer(before, after).run();
}

std::string summaryOf(const std::vector<PlanChange>& changes) {
    constexpr std::array words{"added", "removed", "moved", "renamed", "changed"};
    std::array<int, words.size()> count{};
    for (const PlanChange& change : changes)
        ++count[static_cast<std::size_t>(change.kind)];
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (count[i] > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(count[i]) + ' ' + words[i];
    return text.empty() ? "no difference" : text;
}

} // namespace usar::posh
