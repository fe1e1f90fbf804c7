#include <QTest>

#include "core/mission/files/coverage_course.h"
#include "tests/suite/suite.h"

namespace tst_coverage_course {

using namespace usar;
using namespace usar::mission;

namespace {

/// A run that tells its coverage five times a second, one percent a minute.
CoverageCourse courseOf(double duration_s) {
    CoverageCourse course;
    for (double elapsed_s = 0.0; elapsed_s <= duration_s; elapsed_s += 0.2)
        if (course.due(Seconds{elapsed_s}))
            course.add({Seconds{elapsed_s}, elapsed_s / 60.0});
    return course;
}

} // namespace

class tst_CoverageCourse : public QObject {
    Q_OBJECT
private slots:
    void pointsAreFewAndReachToTheEnd_data() {
        QTest::addColumn<double>("duration_s");
        QTest::addColumn<int>("least");
        QTest::newRow("no time") << 0.0 << 1;
        QTest::newRow("a minute") << 60.0 << 12;
        QTest::newRow("quarter of an hour") << 900.0 << 32;
        QTest::newRow("a day") << 86400.0 << 32;
    }

    void pointsAreFewAndReachToTheEnd() {
        QFETCH(double, duration_s);
        QFETCH(int, least);
        const auto points = courseOf(duration_s).points();
        QVERIFY2(points.size() >= std::size_t(least) && points.size() <= CoverageCourse::most,
                 qPrintable(QString::number(points.size())));
        QCOMPARE(points.front().elapsed.count(), 0.0);
        QVERIFY(points.back().elapsed.count() >= duration_s * 0.9);
        for (std::size_t i = 1; i < points.size(); ++i)
            QVERIFY(points[i - 1].elapsed < points[i].elapsed);
    }

    void pointsKeepTheirCoverage() {
        const CoverageCourse course = courseOf(5000.0);
        for (const CoveragePoint& point : course.points())
            QCOMPARE(point.coverage_pct, point.elapsed.count() / 60.0);
    }
};

USAR_TEST(tst_CoverageCourse)

} // namespace tst_coverage_course

#include "tst_coverage_course.moc"
