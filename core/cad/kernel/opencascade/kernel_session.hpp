#pragma once

// Exclusive use of the kernel, which keeps settings and its application for the whole process. Private to
// this folder.

#include <TDocStd_Document.hxx>
#include <mutex>

namespace hariko {

/// Holds the kernel's lock during its life, with the kernel's controllers initialised and its messages
/// silenced.
class KernelSession {
 public:
  KernelSession();
  KernelSession(const KernelSession&) = delete;
  KernelSession& operator=(const KernelSession&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
};

/// Document of the kernel; closes it at the end of its life.
class KernelDocument {
 public:
  KernelDocument();
  ~KernelDocument();
  KernelDocument(const KernelDocument&) = delete;
  KernelDocument& operator=(const KernelDocument&) = delete;

  Handle(TDocStd_Document) & handle() { return document_; }
  const Handle(TDocStd_Document) & handle() const { return document_; }

 private:
  Handle(TDocStd_Document) document_;
};

}  // namespace hariko
