// Edits of random plans: none leaves a text that cannot be read, and a name that is given back gives the same bytes.
#include <QTest>

#include "core/base/random.h"
#include "core/posh/edit/plan_edits.h"
#include "core/posh/edit/plan_phrase.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token.h"
#include "random_plan.h"
#include "tests/suite/suite.h"

namespace tst_random_plan_edits {

using namespace usar;
using namespace usar::posh;

namespace {

std::size_t lettersOfComments(const std::string& text) {
    std::size_t letters = 0;
    for (const Comment& comment : tokenize(text).comments)
        for (const char c : text.substr(comment.offset, comment.length))
            letters += c == ' ' || c == '\r' ? 0 : 1;
    return letters;
}

Call call(const std::string& words) {
    return readCallPhrase(words).value();
}

Senses senses(const std::string& words) {
    return readSensesPhrase(words).value();
}

/// Makes any edit of any part, also of parts that it does not fit.
class RandomEdit {
public:
    RandomEdit(const std::string& text, Random& random) : text_(text), plan_(readPlan(text).plan), random_(random) {
        parts_ = partsOf(plan_);
    }

    Result<PlanEdit> run() {
        if (parts_.empty())
            return addForm(text_, FormKind::Ap, "first", call("a"));
        const PlanPart one = any();
        const PlanPart other = any();
        const int by = random_() % 2 == 0 ? 1 : -1;
        switch (random_() % 17) {
        case 0:
            return renamePart(text_, one, word());
        case 1:
            return swapParts(text_, one, other);
        case 2:
            return moveMember(text_, one, place(other));
        case 3:
            return moveStep(text_, one, other.form, random_() % 4);
        case 4:
            return shiftPart(text_, one, by);
        case 5:
            return joinLevel(text_, one, by);
        case 6:
            return addMember(text_, place(one), call("act(1)"), senses("(s 3 <)"));
        case 7:
            return addStep(text_, one.form, random_() % 4, call("act"));
        case 8:
            return addSense(text_, one, readSensePhrase("s 0.5 >").value());
        case 9:
            return addForm(text_, static_cast<FormKind>(random_() % 4), word(), call("act"));
        case 10:
            return duplicatePart(text_, one);
        case 11:
            return removePart(text_, one);
        case 12:
            return replaceCall(text_, one, nameOf(plan_, other) ? Call{*nameOf(plan_, other), {}} : call("act"));
        case 13:
            return setSenses(text_, one, senses(random_() % 2 == 0 ? "nil" : "(a) (b \"x\" !=)"));
        case 14:
            return setLimit(text_, one, random_() % 3 == 0 ? "" : random_() % 2 == 0 ? "3" : "seconds 2");
        case 15:
            return setComment(text_, one, "why \"not\"");
        default:
            if (random_() % 3 == 0)
                return wrapParts(text_, one, other, static_cast<FormKind>(random_() % 3));
            return random_() % 2 == 0 ? wrapCall(text_, one, static_cast<FormKind>(random_() % 3))
                                      : inlineCall(text_, one);
        }
    }

private:
    PlanPart any() { return parts_[random_() % parts_.size()].part; }
    MemberPlace place(const PlanPart& near) {
        MemberPlace to{near.form, random_() % 4};
        if (random_() % 2 == 0)
            to.beside = random_() % 3;
        return to;
    }
    std::string word() {
        const char* const words[] = {"fresh", "c0", "p1", "s1", "a2", "nil", "3x", "two words", "goal", "n1", "a.b"};
        return words[random_() % std::size(words)];
    }

    const std::string& text_;
    Plan plan_;
    Random& random_;
    std::vector<NamedPart> parts_;
};

} // namespace

class tst_RandomPlanEdits : public QObject {
    Q_OBJECT
private slots:
    void noEditMakesATextThatCannotBeRead();
    void renamingThereAndBackGivesTheSameBytes();
};

void tst_RandomPlanEdits::noEditMakesATextThatCannotBeRead() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    int done = 0;
    int refused = 0;
    for (std::uint64_t seed = 0; seed < 800; ++seed) {
        Random random = seeded(seed, 5);
        std::string text = writePlan(doubles::randomPlan(random, options));
        for (int i = 0; i < 6; ++i) {
            const auto edited = RandomEdit(text, random).run();
            ++(edited ? done : refused);
            if (!edited)
                continue;
            if (!isReadable(readPlan(edited->text).findings) || edited->text.empty())
                QFAIL((std::to_string(seed) + ":\n" + text + "\nbecame\n" + edited->text).c_str());
            text = edited->text;
        }
    }
    QVERIFY2(done > 1000 && refused > 300, qPrintable(QStringLiteral("%1 done, %2 refused").arg(done).arg(refused)));
}

void tst_RandomPlanEdits::renamingThereAndBackGivesTheSameBytes() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        Random random = seeded(seed, 6);
        const std::string text = writePlan(doubles::randomPlan(random, options));
        const Plan plan = readPlan(text).plan;
        for (const NamedPart& named : partsOf(plan)) {
            const auto there = renamePart(text, named.part, "quite-fresh");
            QVERIFY2(there.has_value(), there ? "" : there.error().text().c_str());
            QCOMPARE(lettersOfComments(there->text), lettersOfComments(text));
            const auto back = renamePart(there->text, named.part, named.name->text);
            if (back) // An odd name may not be allowed again
                QCOMPARE(QString::fromStdString(back->text), QString::fromStdString(text));
        }
    }
}

USAR_TEST(tst_RandomPlanEdits)

} // namespace tst_random_plan_edits

#include "tst_random_plan_edits.moc"
