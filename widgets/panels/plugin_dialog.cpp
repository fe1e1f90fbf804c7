#include "widgets/panels/plugin_dialog.h"

#include <algorithm>

#include <QHeaderView>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int isolated_column = 4;

/// "Behaviors: airrobot/cpp, airrobot/posh"; a dash for an empty list.
QString lineOf(const QString& caption, const QStringList& words) {
    return caption + QStringLiteral(": ") + (words.isEmpty() ? QStringLiteral("–") : words.join(QStringLiteral(", ")));
}

} // namespace

PluginDialog::PluginDialog(const QStringList& folders, QWidget* parent) : QDialog(parent), folders_(folders) {
    setWindowTitle(tr("Plugins"));
    setAccessibleName(windowTitle());
    named(list_, tr("Robot plugins"), tr("Every plugin that was found, and whether it is used"));
    list_->setHeaderLabels({tr("Plugin"), tr("Version"), tr("State"), tr("Behaviors"), tr("Own process")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(3, QHeaderView::Stretch);
    details_->setWordWrap(true);
    details_->setAccessibleName(tr("Selected plugin"));
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    rescan_->setIcon(icon("reset"));
    rescan_->setToolTip(tr("Loads plugins that are new or rebuilt; running behaviors are not affected"));
    close_->setToolTip(tr("Closes this list; plugins stay as they are"));
    for (QPushButton* const button : {rescan_, close_})
        button->setMinimumHeight(minimum_target);
    auto* const foot = laidOut(new QHBoxLayout, gap::small, {rescan_});
    foot->addStretch(1);
    foot->addWidget(close_);
    auto* const column = laidOut(new QVBoxLayout(this), {gap::medium, gap::medium, gap::medium, gap::medium},
                                 gap::small, {list_, details_});
    column->setStretchFactor(list_, 1);
    column->addLayout(foot);
    connect(rescan_, &QPushButton::clicked, this, &PluginDialog::rescanRequested);
    connect(close_, &QPushButton::clicked, this, &QDialog::close);
    connect(list_, &QTreeWidget::currentItemChanged, this, &PluginDialog::showDetails);
    connect(list_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item, int column_changed) {
        if (column_changed == isolated_column)
            emit isolationRequested(item->text(0), item->checkState(isolated_column) == Qt::Checked);
    });
    showDetails();
}

void PluginDialog::setPlugins(const std::vector<PluginRow>& plugins) {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    const QString selected = row < 0 ? QString() : plugins_[std::size_t(row)].file;
    plugins_ = plugins;
    const QSignalBlocker silent(list_);
    list_->clear();
    for (const PluginRow& plugin : plugins_) {
        auto* const item =
            new QTreeWidgetItem(list_, {plugin.name, plugin.version, plugin.state, plugin.behaviors.join(", ")});
        item->setToolTip(2, plugin.reason);
        item->setToolTip(3, plugin.behaviors.join('\n'));
        if (plugin.isolated)
            item->setCheckState(isolated_column, *plugin.isolated ? Qt::Checked : Qt::Unchecked);
        if (plugin.file == selected)
            list_->setCurrentItem(item);
    }
    for (const int column : {0, 1, 2, isolated_column}) {
        list_->resizeColumnToContents(column);
        list_->setColumnWidth(column, list_->columnWidth(column) + gap::medium);
    }
    showDetails();
}

void PluginDialog::showDetails() {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    if (row < 0) {
        details_->setText(plugins_.empty() ? tr("No plugin was found in %1.").arg(folders_.join(", "))
                                           : tr("Select a plugin to see what it needs and where it is."));
        return;
    }
    const PluginRow& plugin = plugins_[std::size_t(row)];
    QStringList lines{lineOf(tr("Behaviors"), plugin.behaviors), lineOf(tr("For robots of class"), plugin.robots),
                      lineOf(tr("Needs sensors"), plugin.sensors), lineOf(tr("File"), {plugin.file})};
    if (!plugin.reason.isEmpty())
        lines.prepend(plugin.reason);
    details_->setText(lines.join('\n'));
}

} // namespace usar::widgets
