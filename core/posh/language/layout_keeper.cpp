#include <algorithm>
#include <string>
#include <vector>

#include "core/posh/language/form_splicer.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_text.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

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
            const std::size_t end = at.offset + at.length;
            chunks_.push_back({begin, at.offset, end, lineRest(text_, end)});
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
    /// Returns a part in the canonical layout, on lines of its own. What precedes it in the text stays if the remarks
    /// above it did not change.
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
        return withLineEnds(text_, result + words + '\n');
    }

    std::string documentation(const std::string& before) {
        const Documentation& wanted = *new_->documentation;
        if (!old_->documentation)
            return rewritten(writeDocumentation(wanted), wanted.remarks.above, nullptr, false, before);
        if (*old_->documentation == wanted)
            return std::string(chunks_.front().of(text_));
        const bool same_above = old_->documentation->remarks.above == wanted.remarks.above;
        return rewritten(writeDocumentation(wanted), wanted.remarks.above, &chunks_.front(), same_above, before);
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
            return rewritten(writeForm(form), remarksOf(form).above, nullptr, false, before);
        const Chunk& chunk = chunks_[index + (old_->documentation ? 1 : 0)];
        const Form& old_form = old_->forms[index];
        if (old_form == form)
            return std::string(chunk.of(text_));
        if (auto kept = spliceForm(text_, tokens_, chunk, old_form, form))
            return *std::move(kept);
        return rewritten(writeForm(form), remarksOf(form).above, &chunk,
                         remarksOf(old_form).above == remarksOf(form).above, before);
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
