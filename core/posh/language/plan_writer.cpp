#include "core/posh/language/plan_writer.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/posh/model/keyword.h"
#include "core/posh/model/literal.h"

namespace usar::posh {

namespace {

void appendArgument(std::string& out, const Argument& argument) {
    if (!argument.name.empty())
        out += '$' + argument.name + '=';
    if (const auto* const literal = std::get_if<Literal>(&argument.value))
        appendLiteral(out, *literal);
    else
        out += '$' + std::get<Variable>(argument.value).name;
}

void appendGoal(std::string& out, const Senses& goal) {
    if (goal.empty())
        return;
    out += " (goal ";
    appendSenses(out, goal);
    out += ')';
}

constexpr std::size_t line_length = 120;

/// Longer names do not move the column after the names.
constexpr std::size_t widest_name = 24;

/// Returns the comment that follows a part on its line, with two blanks before it; empty if there is none.
std::string besideText(const Remarks& remarks) {
    return remarks.beside.empty() ? "" : "  " + commentText(remarks.beside);
}

void appendAbove(std::string& out, const std::vector<std::string>& lines, std::size_t indent) {
    for (const std::string& line : lines)
        out += line.empty() ? "\n" : std::string(indent, ' ') + commentText(line) + '\n';
}

/// Returns the width of the longest name plus a blank. In a level with several members, these are one column farther
/// in.
std::size_t nameWidth(const Levels& levels) {
    std::size_t widest = 0;
    for (const Level& level : levels)
        for (const Member& member : level)
            if (member.name.text.size() <= widest_name)
                widest = std::max(widest, member.name.text.size() + (level.size() > 1 ? 2 : 1));
    return widest;
}

/// Appends the members of one level. `last` points to the comments of the member written last, whose line has not been
/// ended yet; nullptr if there is none.
void appendLevel(std::string& out, const Level& level, std::size_t width, const Remarks*& last) {
    const bool alone = level.size() == 1;
    for (const Member& member : level) {
        const bool is_first = &member == &level.front();
        if (last)
            out += besideText(*last) + '\n';
        appendAbove(out, member.remarks.above, is_first ? 6 : 8);
        out += is_first ? (alone ? "      (" : "      ( ") : "        ";
        appendMember(out, member, alone ? width : width - std::min<std::size_t>(width, 1));
        last = &member.remarks;
    }
    if (!level.empty())
        out += ')';
}

/// Writes a form with levels: its head, the list of levels, the comment string and the parentheses that close them.
template <class Form>
std::string text(const Form& form) {
    const char* const list = std::is_same_v<Form, Collection> ? "(drives" : "(elements";
    std::string out = headText(form) + besideText(form.remarks) + "\n    " + list;
    const std::size_t width = nameWidth(form.levels);
    const Remarks start; // The line with the list's keyword ends like that of a member
    const Remarks* last = form.levels.empty() ? nullptr : &start;
    for (const Level& level : form.levels)
        appendLevel(out, level, width, last);
    if (!form.comment)
        return out + "))" + (last ? besideText(*last) : "");
    out += ')' + besideText(last ? *last : start) + "\n   ";
    appendComment(out, form.comment);
    return out + ')';
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
        appendStep(words, step);
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
    return out + ')' + besideText(pattern.remarks);
}

std::string text(const Adopt& adopt) {
    std::string out = "(AD " + adopt.name.text;
    appendFormals(out, adopt.formals);
    out += " ((goal ";
    appendSenses(out, adopt.goal);
    out += ") (";
    appendCall(out, adopt.adopted);
    return out + ")))" + besideText(adopt.remarks);
}

} // namespace

void appendLiteral(std::string& out, const Literal& literal) {
    out += literal.spelling.empty() ? spelled(literal.value) : literal.spelling;
}

void appendCall(std::string& out, const Call& call) {
    out += call.name.text;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        out += i == 0 ? "(" : ", ";
        appendArgument(out, call.arguments[i]);
    }
    if (!call.arguments.empty())
        out += ')';
}

void appendTest(std::string& out, const SenseTest& test) {
    out += '(';
    appendCall(out, test.call);
    if (test.operand) {
        out += ' ';
        appendLiteral(out, *test.operand);
        if (test.predicate)
            (out += ' ') += toText(*test.predicate);
    }
    out += ')';
}

void appendStep(std::string& out, const Step& step) {
    if (const auto* const test = std::get_if<SenseTest>(&step))
        appendTest(out, *test);
    else
        appendCall(out, std::get<Call>(step));
}

void appendSenses(std::string& out, const Senses& senses) {
    if (senses.empty()) {
        out += "nil";
        return;
    }
    for (std::size_t i = 0; i < senses.size(); ++i) {
        out += i == 0 ? '(' : ' ';
        appendTest(out, senses[i]);
    }
    out += ')';
}

void appendFormals(std::string& out, const std::vector<Formal>& formals) {
    for (std::size_t i = 0; i < formals.size(); ++i) {
        out += i == 0 ? " vars($" : ", $";
        out += formals[i].variable.name + '=';
        appendLiteral(out, formals[i].value);
    }
    if (!formals.empty())
        out += ')';
}

void appendInterval(std::string& out, const std::optional<Interval>& interval) {
    if (!interval)
        return;
    ((out += " (") += toText(interval->unit)) += ' ';
    appendLiteral(out, interval->amount);
    out += ')';
}

void appendComment(std::string& out, const std::optional<Literal>& comment) {
    if (!comment)
        return;
    out += ' ';
    appendLiteral(out, *comment);
}

void appendMember(std::string& out, const Member& member, std::size_t name_width) {
    out += '(' + member.name.text + ' ';
    if (member.name.text.size() + 1 < name_width)
        out.append(name_width - member.name.text.size() - 1, ' ');
    if (!member.trigger.empty()) {
        out += "(trigger ";
        appendSenses(out, member.trigger);
        out += ") ";
    } else if (keywordOf(member.action.name.text) == Keyword::Nil) {
        out += "nil "; // Without it, the action `nil` would be read as the absent trigger
    }
    appendCall(out, member.action);
    appendInterval(out, member.frequency);
    appendComment(out, member.retries);
    appendComment(out, member.comment);
    out += ')';
}

std::string commentText(std::string_view remark) {
    std::string text(remark);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const bool has_mark = text.starts_with(';') || text.starts_with('#');
    return text.empty() || has_mark ? text : "; " + text;
}

std::string keywordText(const Collection& collection) {
    constexpr std::array<std::string_view, 4> words{"DC", "RDC", "SDC", "SRDC"};
    const bool fits = collectionKind(keywordOf(collection.keyword)) == collection.kind;
    return fits ? collection.keyword : std::string(words[static_cast<std::size_t>(collection.kind)]);
}

std::string headText(const Competence& competence) {
    std::string text = "(C " + competence.name.text;
    appendFormals(text, competence.formals);
    appendInterval(text, competence.time_limit);
    appendGoal(text, competence.goal);
    return text;
}

std::string headText(const Collection& collection) {
    std::string text = '(' + keywordText(collection) + ' ' + collection.name.text;
    appendGoal(text, collection.goal);
    return text;
}

std::string writeLevel(const Levels& levels, std::size_t index) {
    std::string out;
    const Remarks* last = nullptr;
    appendLevel(out, levels[index], nameWidth(levels), last);
    return last ? out + besideText(*last) + '\n' : out;
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
    return out + ')' + besideText(documentation.remarks);
}

std::string writePlan(const Plan& plan) {
    std::string out;
    appendAbove(out, plan.remarks.above, 0);
    out += '(' + besideText(plan.remarks) + '\n';
    if (plan.documentation) {
        appendAbove(out, plan.documentation->remarks.above, 2);
        out += "  " + writeDocumentation(*plan.documentation) + '\n';
    }
    for (const Form& form : plan.forms) {
        appendAbove(out, remarksOf(form).above, 2);
        out += "  " + writeForm(form) + '\n';
    }
    appendAbove(out, plan.closing_remarks, 2);
    return out + ")\n";
}

} // namespace usar::posh
