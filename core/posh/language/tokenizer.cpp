#include <algorithm>
#include <array>
#include <string>

#include "core/base/text.h"
#include "core/posh/language/token.h"
#include "core/posh/model/utf8.h"

namespace usar::posh {

namespace {

/// The classes of characters. NameStart and NamePart make up ordinary names; Word is any other ASCII character that can
/// be in a word, valid or not. High is any byte that is not ASCII.
enum class Class : std::uint8_t { Word, NameStart, NamePart, Blank, LineEnd, Open, Close, Delimiter, High };

constexpr std::array<Class, 256> classTable() {
    std::array<Class, 256> table{};
    for (std::size_t i = 0; i < 128; ++i) {
        const char c = static_cast<char>(i);
        if (isLetter(c) || c == '_')
            table[i] = Class::NameStart;
        else if (isDigit(c) || c == '-')
            table[i] = Class::NamePart;
    }
    for (const char c : {' ', '\t', '\r', '\f', '\v'})
        table[static_cast<unsigned char>(c)] = Class::Blank;
    table['\n'] = Class::LineEnd;
    table['('] = Class::Open;
    table[')'] = Class::Close;
    for (const char c : {';', ',', '"', '=', '!', '<', '>', '$', '\'', '#'})
        table[static_cast<unsigned char>(c)] = Class::Delimiter;
    for (std::size_t i = 128; i < 256; ++i)
        table[i] = Class::High;
    return table;
}

constexpr std::array<Class, 256> classes = classTable();

Class classOf(char c) {
    return classes[static_cast<unsigned char>(c)];
}

/// Nobody reads more warnings about single characters than this.
constexpr std::size_t most_warnings = 100;

class Tokenizer {
public:
    explicit Tokenizer(std::string_view text) : text_(text) {
        list_.tokens.reserve(text.size() / 2 + 16); // Enough for a dense plan, so that the list need not grow
        if (text.starts_with("\xEF\xBB\xBF"))
            at_ = line_start_ = 3;
    }

    TokenList run() {
        while (at_ < text_.size())
            next();
        push(TokenKind::End, Keyword::None, spotFrom(at_));
        keepChunk();
        return std::move(list_);
    }

private:
    void passTo(std::size_t end) {
        while (at_ < end)
            if (classOf(text_[at_]) < Class::LineEnd)
                ++at_;
            else
                passCharacter();
    }
    Spot spotFrom(std::size_t begin, std::size_t length = 0) const {
        return {line_, static_cast<std::uint32_t>(begin - line_start_ - extra_bytes_ + 1),
                static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(length)};
    }
    /// Adds a token from `at` to at_ and returns its whole spot.
    Spot add(TokenKind kind, Spot at) {
        at.length = static_cast<std::uint32_t>(at_ - at.offset);
        push(kind, kind == TokenKind::Name ? keywordOf(textOf(text_, at)) : Keyword::None, at);
        return at;
    }
    /// Adds a token from at_ to `end` that consists of single-byte characters only.
    void addPlain(TokenKind kind, Keyword keyword, std::size_t end) {
        const Spot at = spotFrom(at_, end - at_);
        at_ = end;
        push(kind, keyword, at);
    }
    void push(TokenKind kind, Keyword keyword, const Spot& at) {
        *free_++ = {kind, keyword, line_is_empty_, at};
        line_is_empty_ = false;
        if (free_ == chunk_.data() + chunk_.size())
            keepChunk();
    }
    void keepChunk() {
        list_.tokens.insert(list_.tokens.end(), chunk_.data(), free_);
        free_ = chunk_.data();
    }
    Class classAt(std::size_t at) const { return at < text_.size() ? classOf(text_[at]) : Class::Blank; }
    /// Adds a Bad token from `begin` to at_ whose error is at `error_at`.
    void addBad(Code code, const Spot& begin, Spot error_at) {
        if (error_at.length == 0)
            error_at.length = 1;
        list_.errors.push_back({code, error_at});
        add(TokenKind::Bad, begin);
    }

    void next() {
        switch (classOf(text_[at_])) {
        case Class::Blank:
            do
                ++at_;
            while (at_ < text_.size() && classOf(text_[at_]) == Class::Blank);
            return;
        case Class::LineEnd:
            return lineEnd();
        case Class::Open:
            return addPlain(TokenKind::Open, Keyword::None, at_ + 1);
        case Class::Close:
            return addPlain(TokenKind::Close, Keyword::None, at_ + 1);
        case Class::Delimiter:
            return delimiter();
        case Class::High:
            return highCharacter();
        case Class::NameStart:
            return name();
        case Class::NamePart:
            return number();
        case Class::Word:
            return word();
        }
    }
    void warn(Code code, const Spot& at, std::string message) {
        if (list_.warnings.size() > most_warnings)
            return;
        if (list_.warnings.size() == most_warnings)
            message = "there are more such characters and names, which are not listed; fix the ones above first";
        list_.warnings.push_back({code, at, std::move(message)});
    }
    /// Moves past the character at at_ and keeps the line and column counts.
    void passCharacter() {
        if (text_[at_] == '\n') {
            ++at_;
            ++line_;
            line_start_ = at_;
            extra_bytes_ = 0;
            return;
        }
        if (classOf(text_[at_]) != Class::High) {
            ++at_;
            return;
        }
        const CodePoint character = codePointAt(text_, at_);
        if (!character.valid)
            warn(Code::BadByte, spotFrom(at_, 1),
                 "this byte is not valid UTF-8 and is read as U+FFFD; save the file as UTF-8");
        at_ += character.length;
        extra_bytes_ += character.length - 1;
    }
    void lineEnd() {
        // A line without tokens and comments is blank; several blank lines count as one.
        const bool has_comment = !list_.comments.empty() && list_.comments.back().offset >= line_start_;
        if (line_is_empty_ && !has_comment && !line_is_blank_) {
            list_.comments.push_back({static_cast<std::uint32_t>(line_start_), 0, true});
            line_is_blank_ = true;
        } else if (!line_is_empty_ || has_comment) {
            line_is_blank_ = false;
        }
        passCharacter();
        line_is_empty_ = true;
    }
    void highCharacter() {
        const CodePoint character = codePointAt(text_, at_);
        if (!character.valid || !isOddSpace(character.value))
            return word();
        if (odd_spaces_end_ != at_)
            warn(Code::OddSpace, spotFrom(at_, character.length),
                 "this is not an ordinary space, though it looks like one; write a space");
        passCharacter();
        odd_spaces_end_ = at_;
    }
    void delimiter() {
        switch (text_[at_]) {
        case ';':
        case '#':
            return comment();
        case '"':
            return string();
        case '$':
            return word(TokenKind::Variable);
        case '\'':
            return word(TokenKind::Symbol);
        case ',':
            return addPlain(TokenKind::Comma, Keyword::None, at_ + 1);
        default:
            return predicate();
        }
    }
    void predicate() {
        const Spot begin = spotFrom(at_);
        const char first = text_[at_++];
        const bool with_equals = at_ < text_.size() && text_[at_] == '=';
        if (with_equals)
            ++at_;
        if (first == '!' && !with_equals)
            return addBad(Code::IllegalCharacter, begin, begin);
        add(TokenKind::Predicate, begin);
    }
    void comment() {
        const std::size_t begin = at_;
        passTo(std::min(text_.find('\n', at_), text_.size()));
        std::size_t end = at_;
        while (end > begin + 1 && classOf(text_[end - 1]) == Class::Blank)
            --end;
        list_.comments.push_back(
            {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin), line_is_empty_});
    }
    std::size_t wordEnd(std::size_t from) const {
        std::size_t end = from;
        while (end < text_.size()) {
            const Class kind = classOf(text_[end]);
            if (kind <= Class::NamePart) {
                ++end;
                continue;
            }
            if (kind != Class::High)
                break;
            const CodePoint character = codePointAt(text_, end);
            if (character.valid && isOddSpace(character.value))
                break;
            end += character.length;
        }
        return end;
    }
    /// Reads an ordinary name of letters, digits, _ and -; passes any other word on to word().
    void name() {
        std::size_t end = at_ + 1;
        while (classAt(end) == Class::NameStart || classAt(end) == Class::NamePart)
            ++end;
        if (classAt(end) == Class::Word || classAt(end) == Class::High)
            return word();
        addPlain(TokenKind::Name, keywordOf(text_.substr(at_, end - at_)), end);
    }
    /// Reads an ordinary number: digits, with at most one decimal point and an optional minus. Passes any other word on
    /// to word().
    void number() {
        std::size_t end = at_ + (text_[at_] == '-' ? 1 : 0);
        const auto digits = [&] {
            const std::size_t begin = end;
            while (end < text_.size() && isDigit(text_[end]))
                ++end;
            return end - begin;
        };
        std::size_t count = digits();
        const bool has_point = end < text_.size() && text_[end] == '.';
        if (has_point) {
            ++end;
            count += digits();
        }
        const Class follows = classAt(end);
        if (count == 0 || follows <= Class::NamePart || follows == Class::High)
            return word();
        addPlain(has_point ? TokenKind::Float : TokenKind::Integer, Keyword::None, end);
    }
    /// Reads any word that is not quoted, or one after the mark of a variable ($) or a symbol (').
    void word(TokenKind wanted = TokenKind::Name) {
        const Spot begin = spotFrom(at_);
        const bool has_mark = wanted != TokenKind::Name;
        at_ += has_mark ? 1 : 0;
        const std::size_t first = at_;
        const std::size_t end = wordEnd(first);
        const std::string_view rest = text_.substr(first, end - first);
        const Code lone = wanted == TokenKind::Variable ? Code::DollarWithoutName : Code::MalformedSymbol;
        if (has_mark && rest.empty())
            return addBad(lone, begin, begin);
        const WordKind kind = wanted == TokenKind::Symbol ? classifySymbol(rest) : classifyWord(rest);
        passTo(first + kind.bad);
        const Spot bad = spotFrom(at_);
        passTo(end);
        if (kind.error)
            return addBad(*kind.error, begin, bad);
        if (wanted == TokenKind::Variable && kind.kind != TokenKind::Name)
            return addBad(lone, begin, begin); // A number cannot be a name
        const Spot whole = add(has_mark ? wanted : kind.kind, begin);
        if (kind.starts_with_digit)
            warn(Code::NameStartsWithDigit, whole,
                 "the name starts with a digit, which other readers refuse; begin it with a letter");
    }
    /// Returns the length of the escape whose backslash is at `at`, or 0 if it is not a valid escape.
    std::size_t escapeLength(std::size_t at, std::size_t limit) const {
        const auto charAt = [&](std::size_t i) { return i < limit ? text_[i] : '\0'; };
        const auto isOctal = [](char c) { return c >= '0' && c <= '7'; };
        const char first = charAt(at + 1);
        if (first != '\0' && std::string_view("btnfr'\"\\").find(first) != std::string_view::npos)
            return 2;
        if (isOctal(first)) {
            std::size_t digits = 1;
            while (digits < (first <= '3' ? 3U : 2U) && isOctal(charAt(at + 1 + digits)))
                ++digits;
            return 1 + digits;
        }
        std::size_t end = at + 1;
        while (charAt(end) == 'u')
            ++end;
        if (end == at + 1)
            return 0;
        for (std::size_t digit = 0; digit < 4; ++digit) {
            const char c = lowerCase(charAt(end + digit));
            if (!isDigit(c) && !(c >= 'a' && c <= 'f'))
                return 0;
        }
        return end + 4 - at;
    }
    /// Reads a string: adds a String token, or a Bad one with its first error. A string that is never closed ends with
    /// its line, so that the rest of the plan can be read.
    void string() {
        const Spot begin = spotFrom(at_);
        const std::size_t line_end = std::min(text_.find('\n', at_), text_.size());
        const std::size_t limit = string_runs_to_end_ ? line_end : text_.size();
        // First find the end of the string, then count its lines and columns.
        std::size_t end = at_ + 1;
        std::size_t wrong = 0;
        while (end < limit && text_[end] != '"') {
            const std::size_t length = text_[end] == '\\' ? escapeLength(end, limit) : 1;
            if (length == 0 && wrong == 0)
                wrong = end;
            end += length > 0 ? length : std::min<std::size_t>(2, limit - end);
        }
        const bool closed = end < limit;
        string_runs_to_end_ = string_runs_to_end_ || !closed;
        if (!closed && wrong > line_end)
            wrong = 0;
        if (wrong > 0)
            passTo(wrong);
        const Spot wrong_at = spotFrom(at_);
        passTo(closed ? end + 1 : line_end);
        if (wrong > 0)
            return addBad(Code::UnknownEscape, begin, wrong_at);
        if (!closed)
            return addBad(Code::StringNeverClosed, begin, begin);
        add(TokenKind::String, begin);
    }

    std::string_view text_;
    TokenList list_;
    std::array<Token, 128> chunk_; ///< buffer for the newest tokens, cheaper than appending each one to the list
    Token* free_ = chunk_.data();
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    std::size_t extra_bytes_ = 0; ///< continuation bytes of multi-byte characters on this line, up to at_
    std::uint32_t line_ = 1;
    bool line_is_empty_ = true;         ///< no token on this line yet
    bool line_is_blank_ = false;        ///< the line before was blank and has been recorded as a comment
    bool string_runs_to_end_ = false;   ///< a string was never closed, so there is no later closing quote either
    std::size_t odd_spaces_end_ = ~0UL; ///< end of the last odd space; adjacent ones cause one warning only
};

} // namespace

TokenList tokenize(std::string_view text) {
    return Tokenizer(text).run();
}

} // namespace usar::posh
