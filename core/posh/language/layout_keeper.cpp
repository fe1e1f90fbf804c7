#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token_splice.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

/// The bytes of a text that belong to one form or level: what precedes it, the part itself, and the rest of its last
/// line. All fields are byte offsets; ends are exclusive.
struct Chunk {
    std::size_t begin = 0;
    std::size_t body = 0; ///< start of the part itself
    std::size_t body_end = 0;
    std::size_t end = 0;

    /// Returns the bytes of the chunk; `text` must be the text that the offsets refer to.
    std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Returns the offset after the end of the line if only blanks and a comment follow `from` on it, otherwise `from`.
std::size_t lineRest(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size() && text[at] != '\n' && isSpace(text[at]))
        ++at;
    if (at < text.size() && (text[at] == ';' || text[at] == '#'))
        at = std::min(text.find('\n', at), text.size());
    return at < text.size() && text[at] == '\n' ? at + 1 : from;
}

/// Returns `words` with CRLF line ends if `text` has any, except in strings, where a line end is part of the value.
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
        copyTo(token.at.end(), token.kind != TokenKind::String);
    }
    return result;
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
            if (!splice(old.at.offset, old.at.end(), writeForm(std::move(wanted))))
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
        const char* const list_start = std::is_same_v<Kind, Collection> ? " (drives ((" : " (elements ((";
        if (const std::string head = headText(wanted);
            head != headText(old) && !splice(old.at.offset, std::size_t{first.offset} + 1, head + list_start))
            return std::nullopt;
        makeChunks(old.levels);
        std::string out = spliced(text_, chunk_.begin, chunks_.front().begin, splices_);
        for (std::size_t i = 0; i < wanted.levels.size(); ++i)
            appendLevel(out, old.levels, wanted.levels, i);
        splices_.clear();
        std::string tail = ")))";
        appendComment(tail, wanted.comment);
        if (old.comment != wanted.comment && !splice(old.levels.back().back().at.end() - 1, old.at.end(), tail + ')'))
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
            const auto closer = indexAt(level.back().at.end());
            if (chunks_.empty())
                begin = lineRest(text_, (opener - 1)->at.end()); // After the list's keyword
            const std::size_t end = closer->at.end();
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
            if (old[i].remarks != wanted[i].remarks || !splice(old[i].at.offset, old[i].at.end(), words))
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

/// Returns the text of `chunk`, which holds the form `old`, changed so that it holds `wanted`. Both forms must be of
/// the same kind; `tokens` are those of the whole `text`. Returns nullopt if the form must be rewritten as a whole: its
/// own remarks changed, a comment is in the middle of what changes, or one of the two forms has no levels.
std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted) {
    return std::visit(
        [&]<class Kind>(const Kind& any) { return FormSplicer(text, tokens, chunk).run(std::get<Kind>(old), any); },
        wanted);
}

class LayoutKeeper {
public:
    LayoutKeeper(std::string_view text, const Plan& old_plan, const Plan& plan)
        : text_(text)
        , tokens_(tokenize(text))
        , old_(&old_plan)
        , new_(&plan) {
        std::size_t begin = lineRest(text_, tokens_.tokens.front().at.offset + 1);
        prefix_end_ = begin;
        const auto add = [&](const Spot& at) {
            chunks_.push_back({begin, at.offset, at.end(), lineRest(text_, at.end())});
            begin = chunks_.back().end;
        };
        if (old_plan.documentation)
            add(old_plan.documentation->at);
        for (const Form& form : old_plan.forms)
            add(spotOf(form));
    }

    std::string run() {
        std::string out(text_.substr(0, prefix_end_));
        if (new_->documentation)
            out += documentation(out);
        for (const Form& form : new_->forms)
            out += piece(form, out);
        out += text_.substr(chunks_.empty() ? prefix_end_ : chunks_.back().end);
        return out;
    }

private:
    /// Returns a part in the canonical layout, on lines of its own. `chunk` and `old` are those of the part in the
    /// text; nullptr if it is new. What precedes it in the text stays if the remarks above it did not change.
    std::string rewritten(const std::string& words, const Remarks& remarks, const Chunk* chunk, const Remarks* old,
                          const std::string& before) const {
        std::string result;
        if (chunk && old->above == remarks.above) {
            result = text_.substr(chunk->begin, chunk->body - chunk->begin);
        } else {
            if (!before.ends_with('\n'))
                result += '\n';
            for (const std::string& line : remarks.above)
                result += line.empty() ? "\n" : "  " + commentText(line) + '\n';
            result += "  ";
        }
        return withLineEnds(text_, result + words + '\n');
    }

    std::string documentation(const std::string& before) {
        const Documentation& wanted = *new_->documentation;
        const auto& old = old_->documentation;
        if (old == wanted)
            return std::string(chunks_.front().of(text_));
        return rewritten(writeDocumentation(wanted), wanted.remarks, old ? &chunks_.front() : nullptr,
                         old ? &old->remarks : nullptr, before);
    }

    /// Returns the index of the old form that was read from the same place as this one, or the number of old forms if
    /// there is none.
    std::size_t oldIndexOf(const Form& form) const {
        const Spot& at = spotOf(form);
        const auto found =
            std::ranges::lower_bound(old_->forms, at.offset, {}, [](const Form& form) { return spotOf(form).offset; });
        const bool is_it = at.line > 0 && found != old_->forms.end() && spotOf(*found).offset == at.offset &&
                           found->index() == form.index();
        return static_cast<std::size_t>((is_it ? found : old_->forms.end()) - old_->forms.begin());
    }

    std::string piece(const Form& form, const std::string& before) {
        const std::size_t index = oldIndexOf(form);
        if (index == old_->forms.size())
            return rewritten(writeForm(form), remarksOf(form), nullptr, nullptr, before);
        const Chunk& chunk = chunks_[index + (old_->documentation ? 1 : 0)];
        const Form& old_form = old_->forms[index];
        if (old_form == form)
            return std::string(chunk.of(text_));
        if (auto kept = spliceForm(text_, tokens_, chunk, old_form, form))
            return *std::move(kept);
        return rewritten(writeForm(form), remarksOf(form), &chunk, &remarksOf(old_form), before);
    }

    std::string_view text_;
    TokenList tokens_;
    const Plan* old_;
    const Plan* new_;
    std::vector<Chunk> chunks_;
    std::size_t prefix_end_ = 0;
};

/// Removes all comments from the plan and returns how many characters other than blanks they have.
std::size_t takeComments(Plan& plan) {
    std::size_t letters = 0;
    const auto count = [&letters](const std::string& words) {
        letters += words.size() - static_cast<std::size_t>(std::count(words.begin(), words.end(), ' '));
    };
    const auto take = [&count](std::vector<std::string>& lines) {
        for (const std::string& line : lines)
            count(commentText(line));
        lines.clear();
    };
    forEachRemarks(plan, [&](Remarks& remarks) {
        take(remarks.above);
        count(commentText(remarks.beside));
        remarks.beside.clear();
    });
    take(plan.closing_remarks);
    return letters;
}

/// Returns whether both plans are the same and the same amount of comment text is in them. A comment may belong to
/// another part, because a moved form can leave one with its neighbor.
bool sayTheSame(Plan a, Plan b) {
    return takeComments(a) == takeComments(b) && a == b;
}

} // namespace

std::string writeKeepingLayout(std::string_view text, const Plan& plan) {
    const PlanReading old = readPlan(text);
    if (!isReadable(old.findings) || old.plan.remarks != plan.remarks ||
        old.plan.closing_remarks != plan.closing_remarks)
        return writePlan(plan);
    if (old.plan == plan)
        return std::string(text);
    std::string kept = LayoutKeeper(text, old.plan, plan).run();
    // A comment in an unforeseen place could spoil the result; keeping the meaning of the plan is more important than
    // keeping its layout.
    const Plan again = readPlan(kept).plan;
    if (sayTheSame(again, plan))
        return kept;
    std::string canonical = writePlan(plan); // Gives a spelling to literals that the edit left without one
    return sayTheSame(again, readPlan(canonical).plan) ? kept : canonical;
}

} // namespace usar::posh
