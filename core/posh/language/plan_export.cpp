#include "core/posh/language/plan_export.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/text.h"
#include "core/posh/language/form_index.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/literal.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

// Names, values and texts as the dialects allow them. Each function returns valid input unchanged.

/// Replaces everything except letters, digits and underscores by hyphens.
std::string asSymbol(std::string_view text) {
    std::string word(text);
    std::replace_if(
        word.begin(), word.end(), [](char c) { return !isLetter(c) && !isDigit(c) && c != '_'; }, '-');
    return word.empty() || !(isLetter(word.front()) || word.front() == '_') ? '_' + word : word;
}

/// Returns a name without a digit at the start.
std::string yaposhName(std::string_view name) {
    std::string words(name);
    return !words.empty() && isDigit(words.front()) ? '_' + words : words;
}

/// Returns a name without dots and without a digit at the start.
std::string classicName(std::string_view name) {
    std::string words = yaposhName(name);
    std::replace(words.begin(), words.end(), '.', '_');
    return words;
}

/// Returns the value with the hyphens in constants (symbols with dots) replaced by underscores.
Value yaposhValue(const Value& value) {
    const auto* const symbol = std::get_if<Symbol>(&value);
    if (!symbol || symbol->text.find('.') == std::string::npos)
        return value;
    std::string text = symbol->text;
    std::replace(text.begin(), text.end(), '-', '_');
    return Symbol{std::move(text)};
}

/// Returns the value as nil, a number or a symbol without dots: a boolean becomes 1 or 0, a text becomes a symbol, and
/// a constant becomes its last part.
Value classicValue(const Value& value) {
    if (const auto* const truth = std::get_if<bool>(&value))
        return std::int64_t{*truth ? 1 : 0};
    if (const auto* const text = std::get_if<std::string>(&value))
        return Symbol{asSymbol(*text)};
    if (const auto* const symbol = std::get_if<Symbol>(&value))
        return Symbol{yaposhName(symbol->text.substr(symbol->text.rfind('.') + 1))};
    return value;
}

/// Returns the text on one line, with double quotes, backslashes, ; and # replaced by similar characters.
std::string classicText(std::string_view text) {
    std::string plain(text);
    constexpr std::string_view marks = "\";#\\";
    constexpr std::string_view replacements = "',,/";
    for (char& c : plain) {
        if (const std::size_t mark = marks.find(c); mark != std::string_view::npos)
            c = replacements[mark];
        else if (static_cast<unsigned char>(c) < ' ')
            c = ' ';
    }
    return plain;
}

class Exporter {
public:
    Exporter(Plan plan, Dialect dialect)
        : source_(std::move(plan))
        , plan_(source_)
        , index_(source_)
        , dialect_(dialect) {}

    PlanExport run() {
        if (plan_.documentation)
            for (Literal* const part :
                 {&plan_.documentation->title, &plan_.documentation->author, &plan_.documentation->text})
                text(*part);
        for (Form& form : plan_.forms)
            exportForm(form);
        if (isYaposh()) {
            if (!collectionOf(plan_))
                lose({1, 1, 0, 0}, "plan without a drive collection, and nothing was added");
            useSemicolons();
        }
        return {writePlan(plan_), std::move(losses_)};
    }

private:
    bool isYaposh() const { return dialect_ == Dialect::Yaposh; }
    void lose(const Spot& at, const std::string& what) {
        losses_.push_back({at, (isYaposh() ? "yaPOSH has no " : "the classic dialect has no ") + what});
    }

    void exportForm(Form& form) {
        if (const auto* const pattern = std::get_if<Pattern>(&form); pattern && !isYaposh())
            tellOfNestedForms(*pattern);
        forEachCall(form, [this](Call& call, bool) { exportCall(call); });
        std::visit([this](auto& any) { parts(any); }, form);
        if (auto* const adopt = std::get_if<Adopt>(&form); adopt && !isYaposh())
            form = asCompetence(std::move(*adopt));
    }

    template <class AnyForm>
    void parts(AnyForm& form) {
        name(form.name);
        if constexpr (requires { form.formals; })
            if (!isYaposh() && !form.formals.empty()) {
                lose(form.formals.front().variable.at, "parameters, which are left out");
                form.formals.clear();
            }
        if constexpr (requires { form.comment; })
            comment(form.comment);
        if constexpr (requires { form.goal; })
            senses(form.goal);
        if constexpr (requires { form.time_limit; })
            if (isYaposh() && form.time_limit) {
                lose(form.time_limit->at, "time limits, and this one is left out");
                form.time_limit.reset();
            }
        if constexpr (requires { form.levels; })
            for (Level& level : form.levels)
                members(level);
        details(form);
    }

    void details(Competence& competence) {
        if (isYaposh() && !competence.goal.empty()) {
            lose(competence.goal.front().call.name.at, "goal of a competence, which is left out");
            competence.goal.clear();
        }
        if (competence.levels.empty())
            lose(competence.name.at, "competence without elements, and nothing was added");
    }
    void details(Pattern& pattern) {
        if (isYaposh())
            return dropSenseSteps(pattern);
        for (Step& step : pattern.steps)
            if (auto* const test = std::get_if<SenseTest>(&step))
                operand(*test);
    }
    /// Reports calls of forms that the classic dialect does not allow as steps. Call it before the names of the pattern
    /// are converted.
    void tellOfNestedForms(const Pattern& pattern) {
        for (const Step& step : pattern.steps) {
            const auto* const call = std::get_if<Call>(&step);
            const auto form = call ? index_.find(call->name.text) : std::nullopt;
            const bool is_competence = form && std::holds_alternative<Competence>(source_.forms[*form]);
            if (form && (!is_competence || &step != &pattern.steps.back()))
                lose(call->name.at,
                     "step that is a pattern, an adopt or a competence before the last; it stays as it is");
        }
    }
    void details(Adopt& adopt) {
        if (isYaposh() && adopt.goal.empty()) // A goal that is never satisfied, as yaPOSH writes it
            adopt.goal.push_back({{{"cz.cuni.amis.pogamut.sposh.executor.Fail"}}});
    }
    void details(Collection& collection) {
        if (isYaposh())
            return;
        const bool real = wantsRealTime(collection.kind);
        collection.kind = real ? CollectionKind::Srdc : CollectionKind::Sdc;
        collection.keyword = real ? "SRDC" : "SDC";
    }

    void members(Level& level) {
        if (isYaposh() && level.size() > 1)
            lose(level[1].name.at, "members of equal priority: they keep the order in which they are written");
        for (Member& member : level) {
            name(member.name);
            senses(member.trigger);
            comment(member.comment);
            if (member.frequency && member.frequency->unit == Unit::Ticks) {
                lose(member.frequency->at, "frequency in ticks, which is left out");
                member.frequency.reset();
            }
        }
    }

    void exportCall(Call& call) {
        name(call.name);
        if (isYaposh())
            return;
        if (!call.arguments.empty())
            lose(call.arguments.front().at, "arguments, which are left out");
        call.arguments.clear();
    }
    void senses(Senses& tests) {
        for (SenseTest& test : tests)
            operand(test);
    }
    void operand(SenseTest& test) {
        if (!test.operand)
            return;
        Literal& literal = *test.operand;
        const Value value = isYaposh() ? yaposhValue(literal.value) : classicValue(literal.value);
        if (value == literal.value) {
            if (isYaposh() && std::holds_alternative<Symbol>(value))
                literal.spelling = spelled(value); // Adds the quote
            return;
        }
        lose(literal.at, "value " + inQuotes(spelled(literal.value)) + "; it becomes " + inQuotes(spelled(value)));
        literal = {value, spelled(value), literal.at};
    }
    void name(Name& name) {
        std::string words = isYaposh() ? yaposhName(name.text) : classicName(name.text);
        if (words == name.text)
            return;
        lose(name.at, "name like " + inQuotes(name.text) + "; it becomes " + inQuotes(words));
        name.text = std::move(words);
    }
    void comment(std::optional<Literal>& comment) {
        if (comment)
            text(*comment);
    }
    void text(Literal& literal) {
        const auto* const words = std::get_if<std::string>(&literal.value);
        if (isYaposh() || !words)
            return;
        std::string plain = classicText(*words);
        if (plain != *words)
            lose(literal.at, "line ends, quotes, backslashes, ; or # in texts; they are replaced");
        literal.spelling = '"' + plain + '"';
        literal.value = std::move(plain);
    }

    /// Removes the senses among the steps. A pattern that has only senses becomes one that does nothing.
    void dropSenseSteps(Pattern& pattern) {
        std::vector<Step> kept;
        for (Step& step : pattern.steps) {
            if (const auto* const test = std::get_if<SenseTest>(&step))
                lose(test->call.name.at, "sense as a step; the step is left out");
            else
                kept.push_back(std::move(step));
        }
        if (kept.empty())
            kept.emplace_back(Call{{"doNothing"}});
        pattern.steps = std::move(kept);
    }
    /// Converts an adopt to a competence, which also continues until the goal holds, but loses its place when it is
    /// interrupted.
    Competence asCompetence(Adopt adopt) {
        lose(adopt.name.at, "adopt; it becomes a competence, which loses its place when it is interrupted");
        Member element{.name = {adopt.name.text}, .action = std::move(adopt.adopted)};
        return {.name = std::move(adopt.name),
                .goal = std::move(adopt.goal),
                .levels = {{std::move(element)}},
                .remarks = std::move(adopt.remarks),
                .at = adopt.at};
    }

    void useSemicolons() {
        const auto mark = [](std::string& remark) {
            if (remark.starts_with('#'))
                remark.front() = ';';
        };
        forEachRemarks(plan_, [&mark](Remarks& remarks) {
            std::ranges::for_each(remarks.above, mark);
            mark(remarks.beside);
        });
        std::ranges::for_each(plan_.closing_remarks, mark);
    }

    const Plan source_;
    Plan plan_;
    FormIndex index_; ///< index of `source_`
    Dialect dialect_;
    std::vector<Loss> losses_;
};

} // namespace

PlanExport exportPlan(const Plan& plan, Dialect dialect) {
    PlanExport result = Exporter(plan, dialect).run();
    std::ranges::stable_sort(result.losses, {}, [](const Loss& loss) { return loss.at.offset; });
    return result;
}

} // namespace usar::posh
