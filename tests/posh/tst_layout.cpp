// Edited plans keep the bytes of what was not edited.
#include <QTest>

#include <algorithm>
#include <functional>

#include "core/base/random.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/language/token.h"
#include "core/posh/model/plan_walk.h"
#include "plan_corpus.h"
#include "random_plan.h"
#include "tests/suite/suite.h"

namespace tst_layout {

using namespace usar;
using namespace usar::posh;

namespace {

using Edit = std::function<void(Plan&)>;

const std::string source = "; mine\n( ; opened\n"
                           "  (documentation \"a\" \"b\"\n     \"c\")\n"
                           "\n"
                           "  ;; picks it up\n"
                           "  (C pick NIL (GOAL ((holding))) ; header\n"
                           "\t(elements\n"
                           "\t  ((grab   (trigger (near)) close 3)) ; quick\n"
                           "\t  ((go ; why\n\t\tdrive\n\t)) ) )\n"
                           "  (AP wave (up   down)) (AP bow (down))\n"
                           "  # the root\n"
                           "  (rdc me (drives ((a (trigger nil) pick nil)) ((b hop\n(hz 2)))) \"all\")\n"
                           ") ; closed\n";

Competence& competence(Plan& plan) {
    return std::get<Competence>(plan.forms[0]);
}
Collection& collection(Plan& plan) {
    return std::get<Collection>(plan.forms.back());
}

/// `text` with the first `old` replaced.
std::string with(std::string text, const std::string& old, const std::string& wanted) {
    const std::size_t at = text.find(old);
    return at == std::string::npos ? "there is no " + old : text.replace(at, old.size(), wanted);
}

template <class AnyForm>
void editLevels(AnyForm& form, Random& random) {
    if constexpr (requires { form.levels; }) {
        auto& any = form.levels[random() % form.levels.size()];
        if (random() % 3 == 0)
            std::swap(any, form.levels.front());
        else if (random() % 2 == 0)
            any.push_back(form.levels.back().back());
        else if (form.levels.size() > 1)
            form.levels.pop_back();
    }
}

/// Something small happens to the plan.
void editSomewhere(Plan& plan, Random& random) {
    if (plan.forms.empty())
        return;
    Form& form = plan.forms[random() % plan.forms.size()];
    switch (random() % 7) {
    case 0:
        plan.forms.push_back(
            Pattern{{"added" + std::to_string(random() % 1000), {}}, {}, {}, {Call{{"x", {}}, {}}}, {}, {}, {}});
        break;
    case 1:
        std::swap(form, plan.forms.front());
        break;
    case 2:
        plan.forms.erase(plan.forms.begin());
        break;
    case 3:
        remarksOf(form).above.emplace_back("; said later");
        break;
    case 4:
        std::visit([](auto& any) { any.name.text = "renamed"; }, form);
        break;
    case 5:
        std::visit([&random](auto& any) { editLevels(any, random); }, form);
        break;
    default:
        forEachCall(form, [&](Call& call, bool) {
            if (random() % 3 == 0)
                call.name.text = "called";
            else if (random() % 3 == 0)
                call.arguments.clear();
        });
    }
}

/// The plan without its comments, on one line, and the letters of the comments, sorted.
std::string wordsOf(const Plan& plan) {
    const std::string text = writePlan(plan);
    const TokenList list = tokenize(text);
    std::string words;
    for (const Token& token : list.tokens)
        words += std::string(textOf(text, token.at)) + ' ';
    std::string comments;
    for (const Comment& comment : list.comments)
        comments += text.substr(comment.offset, comment.length);
    std::erase(comments, ' ');
    std::sort(comments.begin(), comments.end());
    return words + comments;
}

} // namespace

class tst_Layout : public QObject {
    Q_OBJECT
private slots:
    void nothingEditedKeepsEveryByte_data();
    void nothingEditedKeepsEveryByte();
    void anEditChangesOnlyItsPlace_data();
    void anEditChangesOnlyItsPlace();
    void whatIsMovedTakesItsCommentsAlong();
    void whatCannotBeKeptIsWrittenAnew();
    void lineEndsOfTheTextAreUsed();
    void anyEditReadsBack();
};

void tst_Layout::nothingEditedKeepsEveryByte_data() {
    QTest::addColumn<QByteArray>("text");
    int number = 0;
    for (const corpus::PlanFile& file : corpus::soundPlans())
        QTest::addRow("%d %s", ++number, file.name.c_str()) << QByteArray::fromStdString(file.text);
}

void tst_Layout::nothingEditedKeepsEveryByte() {
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(writeKeepingLayout(text.toStdString(), readPlan(text.toStdString()).plan)),
             text);
}

void tst_Layout::anEditChangesOnlyItsPlace_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const std::string& old, const std::string& wanted, Edit edit) {
        QTest::newRow(name) << std::move(edit) << QString::fromStdString(with(source, old, wanted));
    };
    row("an action is renamed", "(near)) close 3", "((near))) shut 3",
        [](Plan& plan) { competence(plan).levels[0][0].action.name.text = "shut"; });
    row("retries are given", "drive\n", "drive 7\n", [](Plan& plan) {
        competence(plan).levels[1][0].retries = Literal{std::int64_t{7}, "", {}};
    });
    row("retries are taken", "(near)) close 3", "((near))) close",
        [](Plan& plan) { competence(plan).levels[0][0].retries.reset(); });
    row("a sense gets a value", "(near)", "((near 0.5 <))", [](Plan& plan) {
        SenseTest& test = competence(plan).levels[0][0].trigger[0];
        test.operand = Literal{0.5, "", {}};
        test.predicate = Predicate::Less;
    });
    row("a competence is renamed", "C pick NIL", "C take", [](Plan& plan) { competence(plan).name.text = "take"; });
    row("a goal changes", "NIL (GOAL ((holding", "(goal ((held",
        [](Plan& plan) { competence(plan).goal[0].call.name.text = "held"; });
    row("a pattern gets a step", "up   down)", "up   down up)", [](Plan& plan) {
        std::get<Pattern>(plan.forms[1]).steps.emplace_back(Call{{"up", {}}, {}});
    });
    row("a collection's comment changes", "\"all\"", "\"most\"",
        [](Plan& plan) { collection(plan).comment->spelling = "\"most\""; });
    row("a frequency is taken", "hop\n(hz 2)", "hop",
        [](Plan& plan) { collection(plan).levels[1][0].frequency.reset(); });
    row("an element is taken away", "\t  ((grab   (trigger (near)) close 3)) ; quick\n", "",
        [](Plan& plan) { competence(plan).levels.erase(competence(plan).levels.begin()); });
    row("the last element is taken away", "\t  ((go ; why\n\t\tdrive\n\t)) ) )", " ) )",
        [](Plan& plan) { competence(plan).levels.pop_back(); });
    row("an element is added at the end", "\n\t)) ) )", "\n\t))\n      ((rest sleep)) ) )",
        [](Plan& plan) { competence(plan).levels.push_back({Member{.name = {"rest"}, .action = {{"sleep"}}}}); });
    row("elements change places",
        "\t  ((grab   (trigger (near)) close 3)) ; quick\n\t  ((go ; why\n\t\tdrive\n\t)) ) )",
        "\t  ((go ; why\n\t\tdrive\n\t))\n\t  ((grab   (trigger (near)) close 3)) ; quick\n ) )",
        [](Plan& plan) { std::swap(competence(plan).levels[0], competence(plan).levels[1]); });
    row("a drive is added to a level", " ((b hop\n(hz 2)))) \"all\")", "\n      ( (b hop (hz 2))\n        (c sit))))",
        [](Plan& plan) {
            collection(plan).levels[1].push_back(Member{.name = {"c"}, .action = {{"sit"}}});
            collection(plan).comment.reset();
        });
    row("a form is taken away", "  (AP wave (up   down))", "",
        [](Plan& plan) { plan.forms.erase(plan.forms.begin() + 1); });
    row("documentation is taken away", "  (documentation \"a\" \"b\"\n     \"c\")\n", "",
        [](Plan& plan) { plan.documentation.reset(); });
    row("a form is added", "\n\n  ;; picks", "\n  ; about p\n  (AP p (x))\n\n  ;; picks", [](Plan& plan) {
        plan.forms.insert(plan.forms.begin(),
                          Pattern{{"p", {}}, {}, {}, {Call{{"x", {}}, {}}}, {}, {{"about p"}, ""}, {}});
    });
}

void tst_Layout::anEditChangesOnlyItsPlace() {
    QFETCH(Edit, edit);
    QFETCH(QString, expected);
    Plan plan = readPlan(source).plan;
    edit(plan);
    QCOMPARE(QString::fromStdString(writeKeepingLayout(source, plan)), expected);
}

void tst_Layout::whatIsMovedTakesItsCommentsAlong() {
    Plan plan = readPlan(source).plan;
    std::rotate(plan.forms.begin(), plan.forms.begin() + 1, plan.forms.end());
    const std::string written = writeKeepingLayout(source, plan);
    QVERIFY2(readPlan(written).plan == plan, written.c_str());
    QVERIFY2(written.find("(AP wave (up   down)) (AP bow (down))\n  # the root\n  (rdc me") != std::string::npos,
             written.c_str());
    QVERIFY2(written.find("\n\n  ;; picks it up\n  (C pick NIL") != std::string::npos, written.c_str());
}

void tst_Layout::whatCannotBeKeptIsWrittenAnew() {
    Plan plan = readPlan(source).plan;
    QCOMPARE(writeKeepingLayout("( broken", plan), writePlan(plan));
    plan.remarks.above = {"; yours"};
    QCOMPARE(writeKeepingLayout(source, plan), writePlan(plan));
}

void tst_Layout::lineEndsOfTheTextAreUsed() {
    const std::string text = "(\r\n  (DC d (drives ((a p))))\r\n)\r\n";
    Plan plan = readPlan(text).plan;
    Pattern pattern{{"p", {}}, {}, {}, {Call{{"say", {}}, {}}}, {}, {}, {}};
    std::get<Call>(pattern.steps[0]).arguments.push_back({"", Literal{std::string("x\ny"), "\"x\ny\"", {}}, {}});
    plan.forms.emplace_back(pattern);
    QCOMPARE(QString::fromStdString(writeKeepingLayout(text, plan)),
             QString("(\r\n  (DC d (drives ((a p))))\r\n  (AP p (say(\"x\ny\")))\r\n)\r\n"));
}

void tst_Layout::anyEditReadsBack() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Random random = seeded(seed, 2);
        const std::string text = writePlan(doubles::randomPlan(random, options));
        Plan plan = readPlan(text).plan;
        for (std::uint64_t edits = random() % 3; edits > 0; --edits)
            editSomewhere(plan, random);
        const std::string written = writeKeepingLayout(text, plan);
        const Plan again = readPlan(written).plan;
        const Plan wanted = readPlan(writePlan(plan)).plan;
        if (wordsOf(again) != wordsOf(wanted))
            QFAIL((std::to_string(seed) + ":\n" + text + "\nbecame\n" + written).c_str());
    }
}

USAR_TEST(tst_Layout)

} // namespace tst_layout

#include "tst_layout.moc"
