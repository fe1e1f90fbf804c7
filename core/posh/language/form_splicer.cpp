#include "core/posh/language/form_splicer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/posh/language/plan_text.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token_splice.h"

namespace usar::posh {

namespace {

std::size_t endOf(const Spot& at) {
    return std::size_t{at.offset} + at.length;
}

const char* listStart(const Competence&) {
    return " (elements ((";
}

const char* listStart(const Collection&) {
    return " (drives ((";
}

class FormSplicer {
public:
    FormSplicer(std::string_view text, const TokenList& tokens, const Chunk& chunk)
        : text_(text)
        , tokens_(&tokens)
        , chunk_(chunk) {}

    template <class Kind>
    std::optional<std::string> run(const Kind& old, Kind wanted) {
        if (old.remarks != wanted.remarks)
            return std::nullopt;
        if constexpr (requires { wanted.levels; }) {
            return levelled(old, wanted);
        } else {
            wanted.remarks = {}; // They are outside the form
            if (!splice(old.at.offset, endOf(old.at), writeForm(std::move(wanted))))
                return std::nullopt;
            return spliced(text_, chunk_.begin, chunk_.end, splices_);
        }
    }

private:
    bool splice(std::size_t begin, std::size_t end, const std::string& wanted) {
        auto found = spliceTokens(text_, *tokens_, begin, end, wanted);
        if (!found)
            return false;
        splices_.push_back(*std::move(found));
        return true;
    }

    template <class Kind>
    std::optional<std::string> levelled(const Kind& old, const Kind& wanted) {
        if (old.levels.empty() || wanted.levels.empty())
            return std::nullopt;
        const Spot& first = old.levels.front().front().at;
        if (const std::string head = headText(wanted);
            head != headText(old) && !splice(old.at.offset, std::size_t{first.offset} + 1, head + listStart(wanted)))
            return std::nullopt;
        makeChunks(old.levels);
        std::string out = spliced(text_, chunk_.begin, chunks_.front().begin, splices_);
        for (std::size_t i = 0; i < wanted.levels.size(); ++i)
            appendLevel(out, old.levels, wanted.levels, i);
        splices_.clear();
        std::string tail = ")))";
        appendComment(tail, wanted.comment);
        if (old.comment != wanted.comment && !splice(endOf(old.levels.back().back().at) - 1, endOf(old.at), tail + ')'))
            return std::nullopt;
        endLevels(out);
        return out + spliced(text_, chunks_.back().end, chunk_.end, splices_);
    }

    /// Finds the chunks of the old levels. A level extends from the parenthesis before its first member to the one
    /// after its last.
    void makeChunks(const Levels& levels) {
        const auto& all = tokens_->tokens;
        const auto indexAt = [&all](std::size_t offset) {
            return std::ranges::lower_bound(all, offset, {}, [](const Token& token) { return token.at.offset; });
        };
        std::size_t begin = 0;
        for (const Level& level : levels) {
            const auto opener = indexAt(level.front().at.offset) - 1;
            const auto closer = indexAt(endOf(level.back().at));
            if (chunks_.empty())
                begin = lineRest(text_, endOf((opener - 1)->at)); // After the list's keyword
            const std::size_t end = endOf(closer->at);
            chunks_.push_back({begin, opener->at.offset, end, lineRest(text_, end)});
            begin = chunks_.back().end;
        }
    }

    /// Returns the index of the old level that has exactly these members, in this order, or the number of levels if
    /// there is none.
    static std::size_t oldLevelOf(const Levels& levels, const Level& wanted) {
        if (wanted.empty())
            return levels.size();
        const auto found = std::ranges::lower_bound(levels, wanted.front().at.offset, {},
                                                    [](const Level& level) { return level.front().at.offset; });
        const bool is_it =
            found != levels.end() && std::ranges::equal(*found, wanted, [](const auto& a, const auto& b) {
                return b.at.line > 0 && a.at.offset == b.at.offset;
            });
        return static_cast<std::size_t>((is_it ? found : levels.end()) - levels.begin());
    }

    void appendLevel(std::string& out, const Levels& old, const Levels& wanted, std::size_t index) {
        const std::size_t source = oldLevelOf(old, wanted[index]);
        const bool follows = source < old.size() && last_source_ + 1 == source;
        last_source_ = source;
        if (!follows && !out.ends_with('\n'))
            out += '\n';
        splices_.clear();
        if (source < old.size() && spliceMembers(old[source], wanted[index])) {
            const Chunk& chunk = chunks_[source];
            out += spliced(text_, chunk.begin, chunk.end, splices_);
            ends_in_comment_ =
                text_.substr(chunk.body_end, chunk.end - chunk.body_end).find_first_of(";#") != std::string_view::npos;
            return;
        }
        out += withLineEnds(text_, writeLevel(wanted, index));
        ends_in_comment_ = !wanted[index].empty() && !wanted[index].back().remarks.beside.empty();
    }

    /// Collects the splices that change the members of a level. Returns false if a member's comments changed or are in
    /// the way.
    bool spliceMembers(const Level& old, const Level& wanted) {
        for (std::size_t i = 0; i < old.size(); ++i) {
            if (old[i] == wanted[i])
                continue;
            std::string words;
            appendMember(words, wanted[i]);
            if (old[i].remarks != wanted[i].remarks || !splice(old[i].at.offset, endOf(old[i].at), words))
                return false;
        }
        return true;
    }

    /// Keeps the parentheses that close the form where they were: directly after the last level, or on a line of their
    /// own.
    void endLevels(std::string& out) const {
        const Chunk& last = chunks_.back();
        if (last.end != last.body_end && !out.ends_with('\n'))
            out += '\n';
        if (last.end == last.body_end && !ends_in_comment_)
            out.erase(out.find_last_not_of("\r\n") + 1);
    }

    std::string_view text_;
    const TokenList* tokens_;
    Chunk chunk_;
    std::vector<Chunk> chunks_; ///< chunks of the old levels
    std::vector<Splice> splices_;
    std::size_t last_source_ = static_cast<std::size_t>(-1);
    bool ends_in_comment_ = false;
};

} // namespace

std::size_t lineRest(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size() && text[at] != '\n' && isSpace(text[at]))
        ++at;
    if (at < text.size() && (text[at] == ';' || text[at] == '#'))
        at = std::min(text.find('\n', at), text.size());
    return at < text.size() && text[at] == '\n' ? at + 1 : from;
}

std::string withLineEnds(std::string_view text, std::string words) {
    if (text.find("\r\n") == std::string_view::npos)
        return words;
    const TokenList list = tokenize(words);
    std::string result;
    std::size_t done = 0;
    const auto copyTo = [&](std::size_t end, bool converts) {
        for (; done < end; ++done) {
            if (words[done] == '\n' && converts)
                result += '\r';
            result += words[done];
        }
    };
    for (const Token& token : list.tokens) {
        copyTo(token.at.offset, true);
        copyTo(token.at.offset + token.at.length, token.kind != TokenKind::String);
    }
    return result;
}

std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted) {
    return std::visit(
        [&]<class Kind>(const Kind& any) { return FormSplicer(text, tokens, chunk).run(std::get<Kind>(old), any); },
        wanted);
}

} // namespace usar::posh
