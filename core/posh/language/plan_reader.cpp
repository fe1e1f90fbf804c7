#include "core/posh/language/plan_reader.h"

#include <algorithm>
#include <string>

#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/posh/language/form_reader.h"
#include "core/posh/language/token_cursor.h"

namespace usar::posh {

namespace {

class PlanReader {
public:
    PlanReader(std::string_view text, const TokenList& tokens) : list_(&tokens), cursor_(text, tokens) {}

    Plan run() {
        if (!cursor_.at(TokenKind::Open)) {
            cursor_.fail(Code::NotAPlan, "a plan is one list of forms; write ( before " + inQuotes(cursor_.word()));
            return {};
        }
        cursor_.advance();
        while (!cursor_.at(TokenKind::End))
            next();
        if (is_open_)
            cursor_.unexpected("a form or the end of the plan", ")");
        return std::move(plan_);
    }
    Findings takeFindings() { return cursor_.takeFindings(); }
    /// Returns the byte offset of the parenthesis that closes the plan; npos if it is missing.
    std::size_t closing() const { return closing_; }

private:
    /// Reads what comes next outside of all forms: a form, the end of the plan, or text that does not belong there.
    void next() {
        if (!is_open_ && !saw_text_after_)
            afterPlan();
        if (cursor_.at(TokenKind::Open))
            return form();
        if (cursor_.at(TokenKind::Close)) {
            if (is_open_)
                closing_ = cursor_.peek().at.offset;
            is_open_ = false;
            cursor_.advance();
            return;
        }
        if (is_open_ && beginsForm(cursor_.keyword()) && cursor_.at(TokenKind::Name, 1)) {
            cursor_.unexpected("a form or the end of the plan", "( before it");
            cursor_.pretendOpen();
            return form();
        }
        if (is_open_)
            cursor_.unexpected("a form or the end of the plan", "(C …), (AP …), (AD …), (DC …) or )");
        skipJunk();
    }

    /// Reports text after the end of the plan. Forms there are still read, because the cause is nearly always a closing
    /// parenthesis too early.
    void afterPlan() {
        saw_text_after_ = true;
        cursor_.fail(Code::TextAfterPlan, "the plan has ended before " + inQuotes(cursor_.word()) +
                                              "; remove it, or remove a ) that closes the plan too early");
    }

    void skipJunk() {
        while (!cursor_.at(TokenKind::Open) && !cursor_.at(TokenKind::Close) && !cursor_.at(TokenKind::End))
            cursor_.advance();
    }

    /// Reads a form. The current token is its opening parenthesis, or its keyword if the parenthesis is missing and
    /// that has been reported.
    void form() {
        const std::size_t begin_index = cursor_.index();
        const bool is_whole = cursor_.at(TokenKind::Open);
        const std::size_t depth = cursor_.depth() - (is_whole ? 0 : 1);
        const Spot begin = cursor_.peek().at;
        if (is_whole)
            cursor_.advance();
        const bool good = readForm(begin);
        saw_form_ = true;
        if (!good)
            cursor_.resumeAt(endOfBadForm(begin_index), depth);
    }

    bool readForm(const Spot& begin) {
        const Keyword keyword = cursor_.keyword();
        if (const auto kind = collectionKind(keyword))
            return readTheCollection(begin, *kind);
        switch (keyword) {
        case Keyword::Documentation:
            return readDocumentationFirst(begin);
        case Keyword::C:
            return keep(begin, &readCompetence);
        case Keyword::Ap:
            return keep(begin, &readPattern);
        case Keyword::Ad:
            return keep(begin, &readAdopt);
        default:
            return unknownForm();
        }
    }

    bool readDocumentationFirst(const Spot& begin) {
        if (saw_form_)
            return cursor_.fail(Code::LateDocumentation,
                                "the documentation comes after another form; put it first in the plan");
        cursor_.advance();
        Documentation documentation;
        if (!readDocumentation(cursor_, begin, documentation))
            return false;
        plan_.documentation = std::move(documentation);
        return true;
    }

    bool readTheCollection(const Spot& begin, CollectionKind kind) {
        if (saw_collection_)
            return cursor_.fail(
                Code::SecondCollection,
                "a plan has one drive collection and this is the second; put its drives into the first");
        saw_collection_ = true;
        Collection collection;
        collection.kind = kind;
        collection.keyword = cursor_.word();
        cursor_.advance();
        if (!readCollection(cursor_, begin, collection))
            return false;
        plan_.forms.emplace_back(std::move(collection));
        return true;
    }

    bool unknownForm() {
        if (!cursor_.at(TokenKind::Name))
            return cursor_.unexpected("the kind of a form", "C, AP, AD or DC after the (");
        const std::string word = lowerCase(cursor_.word());
        const std::string mend = editDistance(word, "documentation") <= 4 ? "documentation" : "C, AP, AD or DC";
        return cursor_.fail(Code::UnknownForm, inQuotes(cursor_.word()) + " is not a kind of form; write " + mend);
    }

    template <class Kind>
    bool keep(const Spot& begin, bool (*read)(TokenCursor&, const Spot&, Kind&)) {
        cursor_.advance();
        Kind form;
        if (!read(cursor_, begin, form))
            return false;
        plan_.forms.emplace_back(std::move(form));
        return true;
    }

    /// Returns the token at which reading continues after an error: the one after the parenthesis that closes the form,
    /// or, if a parenthesis is missing, the next line that begins a form and is indented no deeper than this one.
    std::size_t endOfBadForm(std::size_t begin) const {
        const auto& tokens = list_->tokens;
        std::size_t depth = tokens[begin].kind == TokenKind::Open ? 0 : 1;
        for (std::size_t i = begin; tokens[i].kind != TokenKind::End; ++i) {
            if (tokens[i].kind == TokenKind::Close && --depth == 0)
                return i + 1;
            if (tokens[i].kind != TokenKind::Open)
                continue;
            if (i > begin && tokens[i].at.column <= tokens[begin].at.column && beginsFormAt(i))
                return i;
            ++depth;
        }
        return tokens.size() - 1;
    }

    bool beginsFormAt(std::size_t index) const {
        const auto& tokens = list_->tokens;
        const std::size_t ahead = index - cursor_.index(); // May wrap around, but then the sum in the cursor wraps back
        return index + 2 < tokens.size() && tokens[index].first_on_line && beginsForm(cursor_.keyword(ahead + 1)) &&
               (tokens[index + 2].kind == TokenKind::Name || tokens[index + 2].kind == TokenKind::String);
    }

    const TokenList* list_;
    TokenCursor cursor_;
    Plan plan_;
    std::size_t closing_ = std::string_view::npos;
    bool is_open_ = true;
    bool saw_form_ = false;
    bool saw_collection_ = false;
    bool saw_text_after_ = false;
};

/// A part that can have remarks, with byte offsets. Comments between `begin` and `end` are inside the part; for a form
/// with levels `end` equals `begin`, because its members have remarks of their own.
struct Holder {
    std::size_t begin = 0;
    std::size_t end = 0;
    Remarks* remarks = nullptr;
};

template <class Part>
Holder wholeHolder(Part& part) {
    return {part.at.offset, part.at.end(), &part.remarks};
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

/// Fills the remarks of all parts of `plan`, which was read from `text`. A comment on a line of its own belongs to the
/// part that begins next, and one after other text to the part that began last. A comment inside a drive, an element,
/// or a form without levels belongs to that part. Comments after `closing`, the byte offset of the plan's closing
/// parenthesis, belong to the plan.
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

void sortByPlace(Findings& findings) {
    std::ranges::stable_sort(findings, {}, [](const Finding& finding) { return finding.at.offset; });
}

} // namespace

PlanReading readPlan(std::string_view text) {
    if (text.size() > longest_plan_bytes)
        return {{},
                {{Code::NotAPlan, {1, 1}, "the text is longer than 64 MiB, the limit for a plan; give another file"}}};
    TokenList tokens = tokenize(text);
    PlanReader reader(text, tokens);
    PlanReading reading{reader.run(), std::move(tokens.warnings)};
    attachRemarks(text, tokens, reader.closing(), reading.plan);
    Findings complaints = reader.takeFindings();
    const bool is_whole = !hasErrors(complaints);
    std::ranges::move(complaints, std::back_inserter(reading.findings));
    sortByPlace(reading.findings);
    Findings checked = checkPlan(reading.plan, is_whole);
    sortByPlace(checked);
    std::ranges::move(checked, std::back_inserter(reading.findings));
    return reading;
}

std::optional<Value> readValue(std::string_view text) {
    const PlanReading reading =
        readPlan("((DC value (drives ((of (trigger ((it " + std::string(text) + "\n))) doNothing)))))");
    const Collection* const collection = collectionOf(reading.plan);
    if (hasErrors(reading.findings) || !collection || collection->levels.size() != 1)
        return std::nullopt;
    const Senses& trigger = collection->levels.front().front().trigger;
    if (collection->levels.front().size() != 1 || trigger.size() != 1 || !trigger.front().operand ||
        trigger.front().predicate)
        return std::nullopt;
    return trigger.front().operand->value;
}

} // namespace usar::posh
