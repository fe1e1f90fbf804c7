#include "core/posh/language/form_splicer.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/posh/language/plan_text.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token_splice.h"

namespace usar::posh {

namespace {

std::size_t endOf(const Spot& at) {
    return std::size_t{at.offset} + at.length;
}

std::string headerText(const Competence& competence) {
    std::string text = "(C " + competence.name.text;
    appendFormals(text, competence.formals);
    appendInterval(text, competence.time_limit);
    appendGoal(text, competence.goal);
    return text + " (elements";
}

std::string headerText(const Collection& collection) {
    std::string text = '(' + keywordText(collection) + ' ' + collection.name.text;
    appendGoal(text, collection.goal);
    return text + " (drives";
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
        if (headerText(old) != headerText(wanted) &&
            !splice(old.at.offset, std::size_t{first.offset} + 1, headerText(wanted) + " (("))
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
    template <class Levels>
    void makeChunks(const Levels& levels) {
        const auto& all = tokens_->tokens;
        const auto indexAt = [&all](std::size_t offset) {
            return std::lower_bound(all.begin(), all.end(), offset,
                                    [](const Token& token, std::size_t at) { return token.at.offset < at; });
        };
        std::size_t begin = 0;
        for (const auto& level : levels) {
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
    template <class Levels>
    std::size_t oldLevelOf(const Levels& levels, const typename Levels::value_type& wanted) const {
        const auto sameMember = [](const auto& a, const auto& b) {
            return b.at.line > 0 && a.at.offset == b.at.offset;
        };
        if (wanted.empty())
            return levels.size();
        const auto found =
            std::lower_bound(levels.begin(), levels.end(), wanted.front().at.offset,
                             [](const auto& level, std::uint32_t offset) { return level.front().at.offset < offset; });
        const bool is_it =
            found != levels.end() && std::equal(found->begin(), found->end(), wanted.begin(), wanted.end(), sameMember);
        return static_cast<std::size_t>((is_it ? found : levels.end()) - levels.begin());
    }

    template <class Levels>
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
    template <class Level>
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

std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted) {
    return std::visit(
        [&]<class Kind>(const Kind& any) { return FormSplicer(text, tokens, chunk).run(std::get<Kind>(old), any); },
        wanted);
}

} // namespace usar::posh
