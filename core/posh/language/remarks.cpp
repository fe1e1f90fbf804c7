#include "core/posh/language/remarks.h"

#include <cstddef>
#include <string>

namespace usar::posh {

namespace {

/// A part that can have remarks, with byte offsets. Comments between `begin` and `end` are inside the part; for a form
/// with levels `end` equals `begin`, because its members have remarks of their own.
struct Holder {
    std::size_t begin = 0;
    std::size_t end = 0;
    Remarks* remarks = nullptr;
};

template <class Part>
Holder wholeHolder(Part& part) {
    return {part.at.offset, part.at.offset + part.at.length, &part.remarks};
}

std::vector<Holder> holdersOf(Plan& plan) {
    std::vector<Holder> holders;
    if (plan.documentation)
        holders.push_back(wholeHolder(*plan.documentation));
    for (Form& form : plan.forms) {
        holders.push_back(std::visit([](auto& any) { return wholeHolder(any); }, form));
        Levels* const levels = levelsIn(form);
        if (!levels)
            continue;
        holders.back().end = holders.back().begin;
        for (Level& level : *levels)
            for (Member& member : level)
                holders.push_back(wholeHolder(member));
    }
    return holders;
}

void putBeside(Remarks& remarks, std::string_view comment) {
    if (comment.empty())
        return; // A blank line inside a part has no meaning
    if (!remarks.beside.empty())
        remarks.beside += ' ';
    remarks.beside += comment;
}

/// Adds a line. Skips a second blank line in a row, which can result if the comment between them went to another part.
void putAbove(std::vector<std::string>& above, std::string_view comment) {
    if (!comment.empty() || above.empty() || !above.back().empty())
        above.emplace_back(comment);
}

} // namespace

void attachRemarks(std::string_view text, const TokenList& tokens, std::size_t closing, Plan& plan) {
    if (tokens.comments.empty())
        return;
    const std::vector<Holder> holders = holdersOf(plan);
    const std::size_t opening = tokens.tokens.front().at.offset;
    std::size_t next = 0;
    for (const Comment& comment : tokens.comments) {
        while (next < holders.size() && holders[next].begin < comment.offset)
            ++next;
        const std::string_view words = text.substr(comment.offset, comment.length);
        Remarks& last = next > 0 ? *holders[next - 1].remarks : plan.remarks;
        const bool inside = next > 0 && comment.offset < holders[next - 1].end;
        if (comment.offset < opening)
            putAbove(plan.remarks.above, words);
        else if (comment.offset > closing)
            putAbove(plan.closing_remarks, words);
        else if (!comment.whole_line || inside)
            putBeside(last, words);
        else
            putAbove(next < holders.size() ? holders[next].remarks->above : plan.closing_remarks, words);
    }
    while (!plan.closing_remarks.empty() && plan.closing_remarks.back().empty())
        plan.closing_remarks.pop_back();
}

} // namespace usar::posh
