// Proposes fixes for one finding; the caller must try out which of them help.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/edit/plan_edits.h"
#include "core/posh/edit/quick_fixes.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/token.h"

namespace usar::posh {

/// Reads the text and proposes fixes by the code of the finding. An object can be used once only; the text, the finding
/// and the vocabulary must outlive it.
class FixFinder {
public:
    FixFinder(std::string_view text, const Finding& finding, const Vocabulary& vocabulary);
    /// Returns the proposals, the likeliest first. They may be wrong, and two of them may give the same text.
    std::vector<QuickFix> run();

private:
    // Defined in text_fixes.cpp.
    void fixCharacters();
    void fixOpenString();
    void fixWord();
    void fixUnexpected();
    void fixParentheses();
    void fixDocumentation();
    void fixUnit();
    void fixNumber();
    void fixPredicate();
    void fixBareName();
    void fixArgumentPlace();
    void fixParameter();
    void fixEmptyList();
    void closeBeforeNextForm();
    void fixTextAfterPlan();
    // Defined in plan_fixes.cpp.
    void fixSimply();
    void fixDuplicate();
    void fixUnknownName();
    void fixWrongUse();
    void fixVariable();
    void fixUndeclared();
    void fixUnreached();
    void fixFindingNothing();
    void fixName();
    void fixMissingCollection();

    // Each of these adds one proposal or more. Places are byte offsets in the text.
    void replace(std::string title, std::size_t begin, std::size_t end, std::string words);
    void insert(std::string title, std::size_t at, std::string_view words) {
        replace(std::move(title), at, at, std::string(words));
    }
    /// Replaces the token at the finding.
    void write(const std::string& words);
    /// Replaces the bytes of the finding.
    void replaceFound(const std::string& words);
    void add(std::string title, std::vector<Splice> edits);
    /// Adds nothing if the edit failed or changes nothing.
    void add(std::string title, const Result<PlanEdit>& edit);
    /// Removes the tokens from the first to the last, inclusive.
    void takeOut(std::size_t first_token, std::size_t last_token);
    /// Replaces the finding by up to `most` of the known words that differ from it in at most `longest_distance`
    /// letters.
    void writeNearest(const std::vector<std::string>& known, std::size_t longest_distance, std::size_t most);

    const Token& token(std::size_t index) const { return tokens_.tokens[std::min(index, tokens_.tokens.size() - 1)]; }
    std::string_view word(std::size_t index) const { return textOf(text_, token(index).at); }
    std::size_t beginOf(std::size_t index) const { return token(index).at.offset; }
    std::size_t endOf(std::size_t index) const { return token(index).at.end(); }
    /// Returns the token that closes the parenthesis `open`, or the last token if there is none.
    std::size_t closing(std::size_t open) const;
    /// Returns the innermost parenthesis open before the token `inside`, or the first token if there is none.
    std::size_t opening(std::size_t inside) const;
    std::string_view found() const { return textOf(text_, finding_.at); }

    std::string_view text_;
    const Finding& finding_;
    const Vocabulary& vocabulary_;
    TokenList tokens_;
    PlanReading reading_;
    std::size_t here_ = 0;         ///< index of the token at the finding
    std::optional<PlanPart> part_; ///< the part at the finding; nullopt outside of all forms
    std::vector<QuickFix> fixes_;
};

} // namespace usar::posh
