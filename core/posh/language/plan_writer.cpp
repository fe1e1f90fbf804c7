#include "core/posh/language/plan_writer.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/posh/language/plan_text.h"

namespace usar::posh {

namespace {

constexpr std::size_t line_length = 120;

/// Longer names do not move the column after the names.
constexpr std::size_t widest_name = 24;

void appendBeside(std::string& out, const Remarks& remarks) {
    if (!remarks.beside.empty())
        out += "  " + commentText(remarks.beside);
    out += '\n';
}

void appendAbove(std::string& out, const std::vector<std::string>& lines, std::size_t indent) {
    for (const std::string& line : lines)
        out += line.empty() ? "\n" : std::string(indent, ' ') + commentText(line) + '\n';
}

/// Returns the width of the longest name plus a blank. In a level with several members, these are one column farther
/// in.
template <class Levels>
std::size_t nameWidth(const Levels& levels) {
    std::size_t widest = 0;
    for (const auto& level : levels)
        for (const auto& member : level)
            if (member.name.text.size() <= widest_name)
                widest = std::max(widest, member.name.text.size() + (level.size() > 1 ? 2 : 1));
    return widest;
}

/// Appends the members of one level. `last` points to the comments of the member written last, whose line has not been
/// ended yet; nullptr if there is none.
template <class Member>
void appendLevel(std::string& out, const std::vector<Member>& level, std::size_t width, const Remarks*& last) {
    const bool alone = level.size() == 1;
    for (const Member& member : level) {
        const bool is_first = &member == &level.front();
        if (last)
            appendBeside(out, *last);
        appendAbove(out, member.remarks.above, is_first ? 6 : 8);
        out += is_first ? (alone ? "      (" : "      ( ") : "        ";
        appendMember(out, member, alone ? width : width - std::min<std::size_t>(width, 1));
        last = &member.remarks;
    }
    if (!level.empty())
        out += ')';
}

/// Appends the levels, the parentheses that close their list and the form, and the comment string.
template <class Form>
void appendLevels(std::string& out, const Form& form) {
    const std::size_t width = nameWidth(form.levels);
    const Remarks start; // The line with the list's keyword ends like that of a member
    const Remarks* last = form.levels.empty() ? nullptr : &start;
    for (const auto& level : form.levels)
        appendLevel(out, level, width, last);
    out += form.comment ? ")" : "))"; // Closes the list, and also the form unless a comment follows
    if (form.comment) {
        appendBeside(out, last ? *last : start);
        out += "   ";
        appendComment(out, form.comment);
        out += ')';
    } else if (last && !last->beside.empty()) {
        out += "  " + commentText(last->beside);
    }
}

template <class Levels>
std::string levelText(const Levels& levels, std::size_t index) {
    std::string out;
    const Remarks* last = nullptr;
    appendLevel(out, levels[index], nameWidth(levels), last);
    if (last)
        appendBeside(out, *last);
    return out;
}

std::string text(const Competence& competence) {
    std::string out = "(C " + competence.name.text;
    appendFormals(out, competence.formals);
    appendInterval(out, competence.time_limit);
    appendGoal(out, competence.goal);
    appendBeside(out, competence.remarks);
    out += "    (elements";
    appendLevels(out, competence);
    return out;
}

std::string text(const Collection& collection) {
    std::string out = '(' + keywordText(collection) + ' ' + collection.name.text;
    appendGoal(out, collection.goal);
    appendBeside(out, collection.remarks);
    out += "    (drives";
    appendLevels(out, collection);
    return out;
}

/// Returns the text of a pattern; the steps are wrapped if the form is too long for one line.
std::string text(const Pattern& pattern) {
    std::string out = "(AP " + pattern.name.text;
    appendFormals(out, pattern.formals);
    appendInterval(out, pattern.time_limit);
    std::vector<std::string> steps;
    std::size_t length = 0;
    for (const Step& step : pattern.steps) {
        std::string& words = steps.emplace_back();
        if (const auto* const test = std::get_if<SenseTest>(&step))
            appendTest(words, *test);
        else
            appendCall(words, std::get<Call>(step));
        length += words.size() + 1;
    }
    const bool wraps = out.size() + length + 4 > line_length;
    out += wraps ? "\n    (" : " (";
    std::size_t column = 5;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool breaks = wraps && i > 0 && column + steps[i].size() + 1 > line_length;
        if (i > 0)
            out += breaks ? "\n     " : " ";
        column = (breaks ? 5 : column + 1) + steps[i].size();
        out += steps[i];
    }
    out += ')';
    appendComment(out, pattern.comment);
    out += ')';
    if (!pattern.remarks.beside.empty())
        out += "  " + commentText(pattern.remarks.beside);
    return out;
}

std::string text(const Adopt& adopt) {
    std::string out = "(AD " + adopt.name.text;
    appendFormals(out, adopt.formals);
    out += " ((goal ";
    appendSenses(out, adopt.goal);
    out += ") (";
    appendCall(out, adopt.adopted);
    out += ")))";
    if (!adopt.remarks.beside.empty())
        out += "  " + commentText(adopt.remarks.beside);
    return out;
}

} // namespace

std::string writeLevel(const std::vector<DriveLevel>& levels, std::size_t index) {
    return levelText(levels, index);
}

std::string writeLevel(const std::vector<ElementLevel>& levels, std::size_t index) {
    return levelText(levels, index);
}

std::string writeForm(const Form& form) {
    return std::visit([](const auto& any) { return text(any); }, form);
}

std::string writeDocumentation(const Documentation& documentation) {
    std::string out = "(documentation";
    for (const Literal* const part : {&documentation.title, &documentation.author, &documentation.text}) {
        out += ' ';
        appendLiteral(out, *part);
    }
    out += ')';
    if (!documentation.remarks.beside.empty())
        out += "  " + commentText(documentation.remarks.beside);
    return out;
}

std::string writePlan(const Plan& plan) {
    std::string out;
    appendAbove(out, plan.remarks.above, 0);
    out += '(';
    appendBeside(out, plan.remarks);
    if (plan.documentation) {
        appendAbove(out, plan.documentation->remarks.above, 2);
        out += "  " + writeDocumentation(*plan.documentation) + '\n';
    }
    for (const Form& form : plan.forms) {
        appendAbove(out, remarksOf(form).above, 2);
        out += "  " + writeForm(form) + '\n';
    }
    appendAbove(out, plan.closing_remarks, 2);
    out += ")\n";
    return out;
}

} // namespace usar::posh
