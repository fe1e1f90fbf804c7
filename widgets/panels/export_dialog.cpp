#include "widgets/panels/export_dialog.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

ExportDialog::ExportDialog(const std::vector<ExportOffer>& offers, QWidget* parent)
    : QDialog(parent)
    , words_(new QLabel(this))
    , folder_(mutedLabel({}, this)) {
    setWindowTitle(tr("Export the map"));
    setAccessibleName(windowTitle());
    words_->setWordWrap(true);
    for (const ExportOffer& offer : offers) {
        auto* const box = new QCheckBox(tr("%1 (.%2): %3").arg(offer.title, offer.id, offer.use), this);
        box->setObjectName(offer.id);
        named(box, offer.title, offer.use);
        connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
        boxes_.push_back(box);
    }
    folder_->setWordWrap(true);
    named(choose_folder_, tr("Change folder"), tr("Chooses the folder for the exported files"));
    named(export_, tr("Export"), tr("Writes the map as it is now in the checked formats"));
    setRole(export_, "primary");
    connect(choose_folder_, &QPushButton::clicked, this, &ExportDialog::folderRequested);
    connect(export_, &QPushButton::clicked, this, [this] {
        close();
        emit exportRequested(chosen());
    });
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    lay();
    refresh();
}

void ExportDialog::lay() {
    choose_folder_->setAutoDefault(false);
    close_->setAutoDefault(false);
    export_->setDefault(true);
    auto* const place = laidOut(new QHBoxLayout, gap::small, {folder_, choose_folder_});
    place->setStretchFactor(folder_, 1);
    auto* const foot = laidOut(new QHBoxLayout, gap::small);
    foot->addStretch(1);
    foot->addWidget(export_);
    foot->addWidget(close_);
    for (QWidget* const control : std::initializer_list<QWidget*>{choose_folder_, export_, close_})
        control->setMinimumHeight(minimum_target);
    auto* const column =
        laidOut(new QVBoxLayout(this), {gap::medium, gap::medium, gap::medium, gap::medium}, gap::small);
    column->addWidget(words_);
    for (QCheckBox* const box : boxes_) {
        box->setMinimumHeight(minimum_target);
        column->addWidget(box);
    }
    column->addLayout(place);
    column->addLayout(foot);
}

void ExportDialog::setRobot(const QString& name) {
    words_->setText(tr("The map of %1 as it is now, in meters and in the frame of the map.").arg(name));
}

void ExportDialog::setFolder(const QString& path) {
    folder_->setText(path);
    folder_->setToolTip(path);
}

void ExportDialog::setChosen(const QStringList& ids) {
    for (QCheckBox* const box : boxes_)
        box->setChecked(ids.contains(box->objectName()));
}

QStringList ExportDialog::chosen() const {
    QStringList ids;
    for (const QCheckBox* const box : boxes_)
        if (box->isChecked())
            ids << box->objectName();
    return ids;
}

void ExportDialog::refresh() {
    export_->setEnabled(!chosen().isEmpty());
}

} // namespace usar::widgets
