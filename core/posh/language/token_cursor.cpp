#include "core/posh/language/token_cursor.h"

#include <algorithm>

namespace usar::posh {

namespace {

std::string lexicalMessage(Code code, std::string_view text, const Spot& at) {
    switch (code) {
    case Code::IllegalCharacter:
        return "the character " + inQuotes(textOf(text, at)) +
               " has no meaning here; names are written with letters, digits, _ and -";
    case Code::StringNeverClosed:
        return "the string is never closed; write \" at its end";
    case Code::UnknownEscape:
        return "there is no such escape; write \\\\ for a backslash, or one of \\n \\t \\\" \\' \\u0041";
    case Code::MalformedNumber:
        return "this is neither a number nor a name; write a number as 12, -3 or 0.5";
    case Code::MalformedSymbol:
        return "a quote begins a symbol; write it as 'red or 'colors.RED";
    case Code::DollarWithoutName:
        return "a dollar sign begins a variable; write its name right after it, as in $speed";
    default:
        return "this is not a name; write letters, digits, _ and -, with dots only between words";
    }
}

} // namespace

void TokenCursor::resumeAt(std::size_t index, std::size_t depth) {
    while (index_ < index)
        advance();
    openers_.resize(std::min(depth, openers_.size()));
}

Spot TokenCursor::spotSince(const Spot& begin) const {
    Spot whole = begin;
    whole.length = static_cast<std::uint32_t>(list_->tokens[index_ - 1].at.end() - begin.offset);
    return whole;
}

bool TokenCursor::takeKeyword(Keyword wanted, std::string_view expected, std::string_view mend) {
    if (keyword() != wanted)
        return unexpected(expected, mend);
    advance();
    return true;
}

bool TokenCursor::unexpected(std::string_view expected, std::string_view mend) {
    const std::string found = at(TokenKind::End) ? "the end of the text" : inQuotes(word());
    return fail(Code::UnexpectedToken, // Completes the message at the end of the text
                "expected " + std::string(expected) + ", found " + found + "; write " + std::string(mend));
}

bool TokenCursor::fail(Code code, std::string message) {
    const Token& token = peek();
    if (token.kind == TokenKind::Bad) {
        const LexicalError& error = list_->errors[errors_passed_];
        return report(error.code, error.at, lexicalMessage(error.code, text_, error.at));
    }
    if (token.kind != TokenKind::End)
        return report(code, token.at, std::move(message));
    if (!findings_.empty() && findings_.back().code == Code::EndOfFile)
        return false; // Report the end of the text only once
    if (openers_.empty())
        message = "the text has no plan in it; write one, as ((DC name (drives ((name action)))))";
    else if (code != Code::UnexpectedToken)
        message = "the text ends too early; close what is open with )";
    report(Code::EndOfFile, token.at, std::move(message));
    if (!openers_.empty())
        findings_.back().opener = tokens_[openers_.back()].at;
    return false;
}

bool TokenCursor::report(Code code, const Spot& at, std::string message) {
    findings_.push_back({code, at, std::move(message)});
    return false;
}

} // namespace usar::posh
