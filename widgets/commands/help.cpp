#include "widgets/commands/help.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "widgets/commands/libraries.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QString explanationOf(const QWidget& part) {
    if (!part.toolTip().isEmpty())
        return part.toolTip();
    return part.accessibleDescription();
}

/// One line for each library: "Qt 6.4.2 (LGPL-3.0-only)".
QString versionsText(const std::vector<Library>& parts) {
    QStringList lines;
    for (const Library& part : parts)
        lines << QStringLiteral("%1 %2 (%3)").arg(part.name, part.version, part.license);
    return lines.join(u'\n');
}

/// A table that shows all of its rows and columns.
class LibraryTable : public QTreeWidget {
public:
    QSize sizeHint() const override {
        const int rows_px = topLevelItemCount() * sizeHintForRow(0);
        return {header()->length() + 2 * frameWidth(), header()->sizeHint().height() + rows_px + 2 * frameWidth()};
    }
};

QTreeWidget* makeLibraryTable(const std::vector<Library>& parts) {
    auto* const table = named(new LibraryTable, QObject::tr("Libraries"),
                              QObject::tr("The libraries that this program has loaded, as they say themselves"));
    table->setHeaderLabels(
        {QObject::tr("Library"), QObject::tr("Version"), QObject::tr("License"), QObject::tr("Used for")});
    table->setRootIsDecorated(false);
    table->setUniformRowHeights(true);
    for (const Library& part : parts)
        new QTreeWidgetItem(table, {part.name, part.version, part.license, part.use});
    table->setSelectionMode(QAbstractItemView::NoSelection);
    for (int column = 0; column < table->columnCount(); ++column) {
        table->resizeColumnToContents(column);
        table->setColumnWidth(column, table->columnWidth(column) + gap::medium);
    }
    return table;
}

} // namespace

QDialog* makeAbout(QWidget* window) {
    auto* const dialog = new QDialog(window);
    dialog->setWindowTitle(QObject::tr("About %1").arg(QCoreApplication::applicationName()));
    dialog->setAccessibleName(dialog->windowTitle());
    const QString program =
        QStringLiteral("%1 %2").arg(QCoreApplication::applicationName(), QCoreApplication::applicationVersion());
    auto* const title = new QLabel(program);
    title->setProperty("role", "title");
    auto* const license = new QLabel(QObject::tr("Free software under the GNU General Public License, version 3 or "
                                                 "later. It comes with no warranty."));
    license->setWordWrap(true);
    for (QLabel* const label : {title, license})
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    const std::vector<Library> parts = libraries();
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* const copy = buttons->addButton(QObject::tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setToolTip(QObject::tr("Copies all versions as text, for a report of an error"));
    QObject::connect(copy, &QPushButton::clicked, dialog,
                     [text = program + u'\n' + versionsText(parts)] { QGuiApplication::clipboard()->setText(text); });
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QTreeWidget* const table = makeLibraryTable(parts);
    laidOut(new QVBoxLayout(dialog), {gap::large, gap::large, gap::large, gap::medium}, gap::medium,
            {title, license, table, buttons});
    dialog->resize(table->sizeHint().width() + 2 * gap::large, dialog->sizeHint().height());
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
