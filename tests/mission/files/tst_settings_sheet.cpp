#include <QTemporaryDir>
#include <QTest>

#include "core/mission/files/last_area.h"
#include "core/mission/files/settings_sheet.h"
#include "tests/suite/suite.h"

namespace tst_settings_sheet {

using namespace usar;

class tst_SettingsSheet : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatHasChangedIsWritten() {
        mission::SettingsSheet written, now;
        written.setValue("theme", "dark");
        written.setValue("record", true);
        now = written;
        QVERIFY(now.changedSince(written).isEmpty());
        now.setValue("theme", "light");
        now.setValue("server/port", 3000);
        QCOMPARE(now.changedSince(written), QVariantMap({{"theme", "light"}, {"server/port", 3000}}));
        QCOMPARE(now.changedSince({}).size(), 3);
    }

    void anAreaComesBackUnlessAFigureIsUnreadable() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("settings.conf");
        mission::SettingsSheet sheet;
        mission::LastArea{"flat", {{-1.5, -2.0}, {3.0, 4.0}}}.save(sheet);
        mission::SettingsSheet::write(sheet.changedSince({}), file);
        const auto read = [&] { return mission::LastArea::from(QSettings(file, QSettings::NativeFormat)); };
        QCOMPARE(read().world, QString("flat"));
        QVERIFY(read().area_in_map == Rectangle({-1.5, -2.0}, {3.0, 4.0}));
        mission::SettingsSheet::write({{"area/max_x_m", "wide"}}, file);
        QVERIFY(read().area_in_map.empty());
        QCOMPARE(read().world, QString("flat"));
    }
};

USAR_TEST(tst_SettingsSheet)

} // namespace tst_settings_sheet

#include "tst_settings_sheet.moc"
