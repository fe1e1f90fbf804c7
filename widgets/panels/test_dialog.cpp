#include "widgets/panels/test_dialog.h"

#include <algorithm>

#include <QFormLayout>
#include <QSignalBlocker>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double usual_span_s = 10.0;
constexpr double shortest_span_s = 0.2; // One tick of the simulator.
constexpr int longest_test_name = 80;

QString markOf(const std::optional<bool>& held) {
    return held == true    ? QObject::tr("held")
           : held == false ? QObject::tr("did not hold")
                           : QObject::tr("not recorded");
}

} // namespace

TestDialog::TestDialog(QWidget* parent)
    : QDialog(parent)
    , words_(mutedLabel({}, this))
    , folder_(mutedLabel({}, this))
    , trouble_(new QLabel(this)) {
    setWindowTitle(tr("Make a test of this moment"));
    setAccessibleName(windowTitle());
    words_->setWordWrap(true);
    folder_->setWordWrap(true);
    folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    named(name_, tr("Name of the test"), tr("The file gets this name"));
    name_->setMaxLength(longest_test_name);
    for (QuantityBox* const box : {from_, for_}) {
        box->setDecimals(1);
        box->setSuffix(tr(" s"));
        connect(box, &QDoubleSpinBox::valueChanged, this, &TestDialog::spanChanged);
    }
    named(from_, tr("Begins at"), tr("When the claim begins, in seconds since the robot appeared"));
    named(for_, tr("Lasts"), tr("How long the claim must hold, or within which time it must come true once"));
    named(list_, tr("Claims"), tr("What the test checks; each says whether it held in this flight"));
    named(choose_folder_, tr("Change folder"), tr("Chooses the folder for tests"));
    named(make_, tr("Make test"), tr("Writes the mission with its seed, its faults and this claim as a file"));
    setRole(make_, "primary");
    trouble_->setWordWrap(true);
    setRole(trouble_, "error");
    trouble_->hide();
    lay();
    nothing_ =
        new EmptyState(list_->viewport(), tr("Nothing to claim"), tr("Choose a time in which the robot was recorded."));
    connect(name_, &QLineEdit::textChanged, this, &TestDialog::refresh);
    connect(list_, &QListWidget::currentRowChanged, this, &TestDialog::refresh);
    connect(choose_folder_, &QPushButton::clicked, this, &TestDialog::folderRequested);
    connect(make_, &QPushButton::clicked, this, &TestDialog::makeRequested);
    connect(close_, &QPushButton::clicked, this, &QWidget::close);
    refresh();
}

void TestDialog::lay() {
    auto* const form = new QFormLayout;
    form->setSpacing(gap::small);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Begins at"), from_);
    form->addRow(tr("Lasts"), for_);
    auto* const place = laidOut(new QHBoxLayout, gap::small, {folder_, choose_folder_});
    place->setStretchFactor(folder_, 1);
    form->addRow(tr("Folder"), place);
    auto* const foot = laidOut(new QHBoxLayout, gap::small);
    foot->addStretch(1);
    foot->addWidget(make_);
    foot->addWidget(close_);
    for (QWidget* const control : std::initializer_list<QWidget*>{name_, from_, for_, choose_folder_, make_, close_})
        control->setMinimumHeight(minimum_target);
    auto* const column =
        laidOut(new QVBoxLayout(this), {gap::medium, gap::medium, gap::medium, gap::medium}, gap::small);
    column->addWidget(words_);
    column->addLayout(form);
    column->addWidget(list_, 1);
    column->addWidget(trouble_);
    column->addLayout(foot);
    resize(460, 460);
}

void TestDialog::setReading(const QString& robot) {
    ready_ = false;
    words_->setText(tr("Reading what %1 has recorded…").arg(robot));
    setOffers({});
    complain({});
}

void TestDialog::setMoment(double at_s, const FlightSpan& known, const QString& name, const QString& caution) {
    ready_ = true;
    words_->setText(tr("The test flies the mission again, with its seed and faults, and checks the claim. It ends with "
                       "the claim.") +
                    (caution.isEmpty() ? QString() : ' ' + caution));
    const QSignalBlocker quiet_from(from_), quiet_for(for_);
    from_->setRange(std::max(0.0, known.from_s), known.to_s);
    from_->setValue(at_s);
    for_->setRange(shortest_span_s, known.to_s - known.from_s + usual_span_s);
    for_->setValue(usual_span_s);
    name_->setText(name);
    refresh();
    list_->setFocus();
}

void TestDialog::setOffers(const std::vector<TestOffer>& offers) {
    const QListWidgetItem* const item = list_->currentItem();
    const QString before = item ? item->data(Qt::UserRole).toString() : QString();
    int row = offers.empty() ? -1 : 0;
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const TestOffer& offer : offers) {
            auto* const added = new QListWidgetItem(offer.text + " — " + markOf(offer.held), list_);
            added->setData(Qt::UserRole, offer.text);
            if (offer.text == before)
                row = list_->count() - 1;
        }
        list_->setCurrentRow(row);
    }
    refresh();
}

void TestDialog::setFolder(const QString& folder) {
    folder_->setText(folder);
}

void TestDialog::complain(const QString& text) {
    trouble_->setText(text);
    trouble_->setVisible(!text.isEmpty());
}

FlightSpan TestDialog::span() const {
    return {from_->value(), from_->value() + for_->value()};
}

void TestDialog::refresh() {
    for (QWidget* const control : std::initializer_list<QWidget*>{name_, from_, for_, list_})
        control->setEnabled(ready_);
    make_->setEnabled(ready_ && chosen() >= 0 && !name().isEmpty());
    nothing_->setVisible(ready_ && list_->count() == 0);
}

} // namespace usar::widgets
