// SPDX-License-Identifier: GPL-3.0-or-later
// Tells ThreadSanitizer what Qt orders where it does not look: a call that is queued, and work that is given
// to a pool of threads, begin after what was done before they were handed over. Takes the place of the two
// functions of Qt by which that is done, and hands on to them. Itself not built for the checker, so that it
// may read what it carries before it has told of the order.
#include <QMetaObject>
#include <QThreadPool>

#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>

#include <functional>
#include <utility>

namespace {

// A slot of Qt's that is called in order.
struct OrderedSlot : QtPrivate::QSlotObjectBase {
  explicit OrderedSlot(QtPrivate::QSlotObjectBase* taken) : QSlotObjectBase(&handle), slot(taken) {}

  static void handle(int what, QSlotObjectBase* self, QObject* receiver, void** arguments, bool*) {
    auto* ordered = static_cast<OrderedSlot*>(self);
    __tsan_acquire(ordered);
    if (what == Call) {
      ordered->slot->call(receiver, arguments);
      __tsan_release(ordered); // whoever lets go of it last destroys it
    } else if (what == Destroy) {
      ordered->slot->destroyIfLastRef();
      delete ordered;
    }
  }

  QtPrivate::QSlotObjectBase* slot;
};

template <typename Function>
Function* qtsOwn(const char* symbol) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, symbol));
}

char handedOver; // of all work, since what carries it is copied

} // namespace

#define INVOKE                                                                                               \
  "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv"
#define START "_ZN11QThreadPool5startESt8functionIFvvEEi"

// Under the names that they have in Qt: one is private there, the other a member.
bool invoke(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType, void*) __asm__(INVOKE);
void start(QThreadPool*, std::function<void()>, int) __asm__(START);

bool invoke(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type, void* result) {
  static auto* const own = qtsOwn<decltype(invoke)>(INVOKE);
  auto* const ordered = new OrderedSlot(slot);
  __tsan_release(ordered);
  return own(object, ordered, type, result);
}

void start(QThreadPool* pool, std::function<void()> work, int priority) {
  static auto* const own = qtsOwn<decltype(start)>(START);
  std::function<void()> ordered = [work = std::move(work)] {
    __tsan_acquire(&handedOver);
    work();
  };
  __tsan_release(&handedOver);
  own(pool, std::move(ordered), priority);
}
