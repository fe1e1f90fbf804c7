#include <QTest>

#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "plan_corpus.h"
#include "random_plan.h"
#include "tests/suite/suite.h"

namespace tst_plan_writer {

using namespace usar;
using namespace usar::posh;

namespace {

/// What differs after the plan was written and read, or nothing.
std::string roundTripComplaint(const Plan& plan) {
    const std::string written = writePlan(plan);
    const PlanReading again = readPlan(written);
    if (hasErrors(again.findings))
        return toText(again.findings.front()) + " in\n" + written;
    if (again.plan != plan)
        return "reads back as another plan:\n" + written;
    return writePlan(again.plan) == written ? "" : "is written differently the second time:\n" + written;
}

} // namespace

class tst_PlanWriter : public QObject {
    Q_OBJECT
private slots:
    void canonicalLayoutIsAsDescribed();
    void whatIsWrittenReadsTheSame_data();
    void whatIsWrittenReadsTheSame();
    void tenThousandRandomPlansReadTheSame();
};

void tst_PlanWriter::canonicalLayoutIsAsDescribed() {
    const std::string text =
        "; on top\n\n\n( # beside\n (documentation \"a\" \"b\" \"c\")\n"
        "(AP p(a (s 3 >)) \"why\") ; p\n"
        ";; about it\n(C c (MINUTES 2.50)(goal(x)) ;c\n(elements((e\n (trigger((s(1,$y=2) nil =)))\n"
        "do ; inside\n 3)(longer p))\n\n ((last q nil \"text\"))) ; end\n \"of c\")\n"
        "(rdc life (drives ((a c (HZ 2.0))))) ; done\n)\n; behind\n";
    const std::string expected = "; on top\n"
                                 "\n"
                                 "(  # beside\n"
                                 "  (documentation \"a\" \"b\" \"c\")\n"
                                 "  (AP p (a (s 3 >)) \"why\")  ; p\n"
                                 "  ;; about it\n"
                                 "  (C c (minutes 2.50) (goal ((x)))  ;c\n"
                                 "    (elements\n"
                                 "      ( (e      (trigger ((s(1, $y=2) nil ==))) do 3)  ; inside\n"
                                 "        (longer p))\n"
                                 "\n"
                                 "      ((last    q \"text\")))  ; end\n"
                                 "    \"of c\")\n"
                                 "  (rdc life\n"
                                 "    (drives\n"
                                 "      ((a c (hz 2.0)))))  ; done\n"
                                 "  ; behind\n"
                                 ")\n";
    QCOMPARE(QString::fromStdString(writePlan(readPlan(text).plan)), QString::fromStdString(expected));
}

void tst_PlanWriter::whatIsWrittenReadsTheSame_data() {
    QTest::addColumn<QByteArray>("text");
    int number = 0;
    for (const corpus::PlanFile& file : corpus::soundPlans())
        QTest::addRow("%d %s", ++number, file.name.c_str()) << QByteArray::fromStdString(file.text);
}

void tst_PlanWriter::whatIsWrittenReadsTheSame() {
    QFETCH(QByteArray, text);
    const std::string complaint = roundTripComplaint(readPlan(text.toStdString()).plan);
    QVERIFY2(complaint.empty(), complaint.c_str());
}

void tst_PlanWriter::tenThousandRandomPlansReadTheSame() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    for (std::uint64_t seed = 0; seed < 10000; ++seed) {
        Random random = seeded(seed, 1);
        options.with_collection = seed % 10 != 0;
        const Plan plan = doubles::randomPlan(random, options);
        const std::string complaint = roundTripComplaint(plan);
        QVERIFY2(complaint.empty(), (std::to_string(seed) + ": " + complaint).c_str());
    }
}

USAR_TEST(tst_PlanWriter)

} // namespace tst_plan_writer

#include "tst_plan_writer.moc"
