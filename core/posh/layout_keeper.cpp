#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/posh/plan_reader.h"
#include "core/posh/plan_text.h"
#include "core/posh/plan_writer.h"
#include "core/posh/token_splice.h"

namespace usar::posh {

namespace {

/// A form or the documentation in the old text: what stands before it, itself, and the rest of its last line.
struct Chunk {
    std::size_t begin = 0;
    std::size_t body = 0;
    std::size_t body_end = 0;
    std::size_t end = 0;
};

class LayoutKeeper {
public:
    LayoutKeeper(std::string_view text, const Plan& old_plan, const Plan& plan)
        : text_(text)
        , tokens_(tokenize(text))
        , old_(&old_plan)
        , new_(&plan) {
        std::size_t begin = lineRest(tokens_.tokens.front().at.offset + 1);
        prefix_end_ = begin;
        const auto add = [&](const Spot& at) {
            const std::size_t end = at.offset + at.length;
            chunks_.push_back({begin, at.offset, end, lineRest(end)});
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
    /// Behind the end of the line, if only blanks and a comment are left of it; else `from`.
    std::size_t lineRest(std::size_t from) const {
        std::size_t at = from;
        while (at < text_.size() && text_[at] != '\n' && isSpace(text_[at]))
            ++at;
        if (at < text_.size() && (text_[at] == ';' || text_[at] == '#'))
            at = std::min(text_.find('\n', at), text_.size());
        return at < text_.size() && text_[at] == '\n' ? at + 1 : from;
    }

    std::string verbatim(const Chunk& chunk) const {
        return std::string(text_.substr(chunk.begin, chunk.end - chunk.begin));
    }

    /// Line ends as the text has them; those within strings are part of their values.
    std::string withLineEnds(std::string words) const {
        if (text_.find("\r\n") == std::string_view::npos)
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

    /// In the canonical layout, on lines of its own. What stood before it stays, if the remarks are the same.
    std::string rewritten(const std::string& words, const std::vector<std::string>& above, const Chunk* chunk,
                          bool same_above, const std::string& before) const {
        std::string result;
        if (chunk && same_above) {
            result = text_.substr(chunk->begin, chunk->body - chunk->begin);
        } else {
            if (!before.ends_with('\n'))
                result += '\n';
            for (const std::string& line : above)
                result += line.empty() ? "\n" : "  " + commentText(line) + '\n';
            result += "  ";
        }
        return withLineEnds(result + words + '\n');
    }

    std::string documentation(const std::string& before) {
        const Documentation& wanted = *new_->documentation;
        if (!old_->documentation)
            return rewritten(writeDocumentation(wanted), wanted.remarks.above, nullptr, false, before);
        if (*old_->documentation == wanted)
            return verbatim(chunks_.front());
        const bool same_above = old_->documentation->remarks.above == wanted.remarks.above;
        return rewritten(writeDocumentation(wanted), wanted.remarks.above, &chunks_.front(), same_above, before);
    }

    /// Of the old form that stood where this one was read; one past the last where there is none.
    std::size_t oldIndexOf(const Form& form) const {
        const Spot& at = spotOf(form);
        const auto found = std::lower_bound(
            old_->forms.begin(), old_->forms.end(), at.offset,
            [](const Form& candidate, std::uint32_t offset) { return spotOf(candidate).offset < offset; });
        const bool is_it = at.line > 0 && found != old_->forms.end() && spotOf(*found).offset == at.offset &&
                           found->index() == form.index();
        return static_cast<std::size_t>((is_it ? found : old_->forms.end()) - old_->forms.begin());
    }

    std::string piece(const Form& form, const std::string& before) {
        const std::size_t index = oldIndexOf(form);
        if (index == old_->forms.size())
            return rewritten(writeForm(form), remarksOf(form).above, nullptr, false, before);
        const Chunk& chunk = chunks_[index + (old_->documentation ? 1 : 0)];
        const Form& old_form = old_->forms[index];
        if (old_form == form)
            return verbatim(chunk);
        std::vector<Splice> splices;
        if (remarksOf(old_form) == remarksOf(form) && spliceForm(old_form, form, splices))
            return spliced(text_, chunk.begin, chunk.end, splices);
        return rewritten(writeForm(form), remarksOf(form).above, &chunk,
                         remarksOf(old_form).above == remarksOf(form).above, before);
    }

    bool splice(std::size_t begin, std::size_t end, const std::string& wanted, std::vector<Splice>& splices) const {
        auto found = spliceTokens(text_, tokens_, begin, end, wanted);
        if (found)
            splices.push_back(*std::move(found));
        return found.has_value();
    }

    /// False where the form must be written anew.
    bool spliceForm(const Form& old_form, const Form& form, std::vector<Splice>& splices) const {
        return std::visit(
            [&]<class Kind>(const Kind& wanted) {
                const Kind& old = std::get<Kind>(old_form);
                if constexpr (requires { wanted.levels; })
                    return spliceLevels(old, wanted, splices);
                else
                    return splice(old.at.offset, old.at.offset + old.at.length, writeBare(wanted), splices);
            },
            form);
    }
    template <class Kind>
    static std::string writeBare(Kind form) {
        form.remarks = {};
        return writeForm(std::move(form));
    }

    template <class Kind>
    bool spliceLevels(const Kind& old, const Kind& wanted, std::vector<Splice>& splices) const {
        if (!sameShape(old.levels, wanted.levels) || old.levels.empty())
            return false;
        const Spot& first = old.levels.front().front().at;
        const Spot& last = old.levels.back().back().at;
        if (headerText(old) != headerText(wanted) &&
            !splice(old.at.offset, first.offset + 1, headerText(wanted) + " ((", splices))
            return false;
        for (std::size_t i = 0; i < old.levels.size(); ++i)
            for (std::size_t j = 0; j < old.levels[i].size(); ++j)
                if (!spliceMember(old.levels[i][j], wanted.levels[i][j], splices))
                    return false;
        std::string tail = ")))";
        appendComment(tail, wanted.comment);
        return old.comment == wanted.comment ||
               splice(last.offset + last.length - 1, old.at.offset + old.at.length, tail + ')', splices);
    }

    template <class Member>
    bool spliceMember(const Member& old, const Member& wanted, std::vector<Splice>& splices) const {
        if (old == wanted)
            return true;
        std::string words;
        appendMember(words, wanted);
        return old.remarks == wanted.remarks && splice(old.at.offset, old.at.offset + old.at.length, words, splices);
    }

    /// Each member stands where it stood.
    template <class Levels>
    static bool sameShape(const Levels& old, const Levels& wanted) {
        const auto sameMember = [](const auto& a, const auto& b) {
            return b.at.line > 0 && a.at.offset == b.at.offset;
        };
        return std::equal(old.begin(), old.end(), wanted.begin(), wanted.end(), [&](const auto& a, const auto& b) {
            return !a.empty() && std::equal(a.begin(), a.end(), b.begin(), b.end(), sameMember);
        });
    }

    static std::string headerText(const Competence& competence) {
        std::string text = "(C " + competence.name.text;
        appendFormals(text, competence.formals);
        appendInterval(text, competence.time_limit);
        appendGoal(text, competence.goal);
        return text + " (elements";
    }
    static std::string headerText(const Collection& collection) {
        std::string text = '(' + keywordText(collection) + ' ' + collection.name.text;
        appendGoal(text, collection.goal);
        return text + " (drives";
    }

    std::string_view text_;
    TokenList tokens_;
    const Plan* old_;
    const Plan* new_;
    std::vector<Chunk> chunks_;
    std::size_t prefix_end_ = 0;
};

/// Calls `visit` with the remarks of every part.
template <class AnyPlan, class Visit>
void forEachRemarks(AnyPlan& plan, Visit&& visit) {
    visit(plan.remarks);
    if (plan.documentation)
        visit(plan.documentation->remarks);
    for (auto& form : plan.forms)
        std::visit(
            [&visit](auto& any) {
                visit(any.remarks);
                if constexpr (requires { any.levels; })
                    for (auto& level : any.levels)
                        for (auto& member : level)
                            visit(member.remarks);
            },
            form);
}

/// Takes all comments out of the plan and gives how many letters they have.
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

/// Whether the texts hold the same plan, and all comments, though a moved form may leave one to its neighbor.
bool sayTheSame(Plan a, Plan b) {
    return takeComments(a) == takeComments(b) && a == b;
}

} // namespace

std::string writeKeepingLayout(std::string_view text, const Plan& plan) {
    const PlanReading old = readPlan(text);
    if (hasErrors(old.findings) || old.plan.remarks != plan.remarks || old.plan.closing_remarks != plan.closing_remarks)
        return writePlan(plan);
    if (old.plan == plan)
        return std::string(text);
    std::string kept = LayoutKeeper(text, old.plan, plan).run();
    // Comments may stand where nobody thought of; what a person meant goes before how it looked.
    const Plan again = readPlan(kept).plan;
    if (sayTheSame(again, plan))
        return kept;
    std::string canonical = writePlan(plan); // literals that the edit left without a spelling have one now
    return sayTheSame(again, readPlan(canonical).plan) ? kept : canonical;
}

} // namespace usar::posh
