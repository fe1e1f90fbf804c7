#include "widgets/commands/help.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QObject>
#include <QVBoxLayout>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QString explanationOf(const QWidget& part) {
    if (!part.toolTip().isEmpty())
        return part.toolTip();
    return part.accessibleDescription();
}

} // namespace

QDialog* makeAbout(QWidget* window) {
    auto* const dialog = new QDialog(window);
    dialog->setWindowTitle(QObject::tr("About %1").arg(QCoreApplication::applicationName()));
    dialog->setAccessibleName(dialog->windowTitle());
    auto* const title = new QLabel(
        QObject::tr("%1 %2").arg(QCoreApplication::applicationName(), QCoreApplication::applicationVersion()));
    title->setProperty("role", "title");
    auto* const license = new QLabel(QObject::tr("Free software under the GNU General Public License, version 3 or "
                                                 "later. It comes with no warranty."));
    auto* const parts =
        new QLabel(QObject::tr("Qt %1: LGPL-3.0\nBullet Physics: Zlib\nEigen: MPL-2.0\n"
                               "sdformat: Apache-2.0\nQCustomPlot: GPL-3.0-or-later\ntl::expected: CC0-1.0\nSDL: "
                               "Zlib\nzlib: Zlib\nlibpng: libpng-2.0\nlibjpeg-turbo: IJG and BSD-3-Clause")
                       .arg(QString::fromLatin1(qVersion())));
    for (QLabel* const label : {title, license, parts}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    }
    laidOut(new QVBoxLayout(dialog), {gap::large, gap::large, gap::large, gap::large}, gap::medium,
            {title, license, parts});
    dialog->resize(420, dialog->sizeHint().height());
    return dialog;
}

void explainParts(QWidget& window) {
    constexpr const char* from_tip = "usar_explained_by_tip"; // Tooltips change, so these are renewed.
    for (QWidget* const part : window.findChildren<QWidget*>())
        if (part->whatsThis().isEmpty() || part->property(from_tip).toBool()) {
            part->setWhatsThis(explanationOf(*part));
            part->setProperty(from_tip, true);
        }
    for (QDockWidget* const dock : window.findChildren<QDockWidget*>()) {
        const QString inside = dock->widget() ? explanationOf(*dock->widget()) : QString();
        if (dock->whatsThis().isEmpty())
            dock->setWhatsThis(inside.isEmpty() ? dock->windowTitle() : dock->windowTitle() + ": " + inside);
    }
}

} // namespace usar::widgets
