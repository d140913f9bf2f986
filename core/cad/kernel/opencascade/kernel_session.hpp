#pragma once

// The kernel keeps settings and its application for the whole process: one at a time. Only for this folder.

#include <TDocStd_Document.hxx>
#include <mutex>

namespace hariko {

/// While it lives nobody else uses the kernel. Its controllers are there and it prints nothing.
class KernelSession {
 public:
  KernelSession();
  KernelSession(const KernelSession&) = delete;
  KernelSession& operator=(const KernelSession&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
};

/// A document of the kernel, which is closed with it.
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
